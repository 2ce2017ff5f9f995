"""The script ./waterlight around a build: what it does is seen through programs of our own in the place of apt-get, cmake and ninja.

start_script_test.py REPOSITORY
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

REPOSITORY = pathlib.Path(sys.argv.pop(1))


class StartScript(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name) / "with a blank"
        self.tools = self.root / "tools"
        self.tools.mkdir(parents=True)
        (self.root / "tests/fuzz/seeds/esri").mkdir(parents=True)
        for name in ("waterlight", "packages.txt"):
            shutil.copy(REPOSITORY / name, self.root)
        self.log = self.root / "log"
        self.log.touch()
        everything = "sed -e '/^#/d' -e 's/^[a-z]*: //' -e 's/^/installed /' " + f"'{self.root}/packages.txt'"
        self.tool("dpkg-query", everything)
        self.tool("apt-get", "exit 9")
        self.tool("cmake", f"mkdir -p build/release && touch build/release/build.ninja && "
                           f"echo 'CMAKE_HOME_DIRECTORY:INTERNAL={self.root}' >build/release/CMakeCache.txt")
        self.tool("ninja", "case \" $* \" in *\" -n \"*) exit 0 ;; esac; echo begin >>log; echo end >>log")
        program = self.root / "build/release/app/waterlight"
        program.parent.mkdir(parents=True)
        program.write_text("#!/bin/sh\necho \"the program: $*\"\nexit 5\n")
        program.chmod(0o755)

    def tool(self, name, text):
        file = self.tools / name
        file.write_text(f"#!/bin/bash\ncd '{self.root}'\n{text}\n")
        file.chmod(0o755)

    def start(self, *arguments):
        return subprocess.Popen([self.root / "waterlight", *arguments], text=True, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, env=os.environ | {"PATH": f"{self.tools}:{os.environ['PATH']}"})

    def finish(self, *arguments):
        process = self.start(*arguments)
        output, messages = process.communicate(timeout=60)
        return process.returncode, output, messages

    def test_builds_and_hands_over_arguments_output_and_exit_status(self):
        status, output, messages = self.finish("run", "a file.toml")
        self.assertEqual((status, output), (5, "the program: run a file.toml\n"))
        self.assertIn("waterlight: configuring\n", messages)
        self.assertEqual(self.log.read_text(), "begin\nend\n")

    def test_two_do_not_build_in_one_folder_at_a_time(self):
        self.tool("ninja", "case \" $* \" in *\" -n \"*) exit 0 ;; esac; echo begin >>log; "
                           "until [ -e go ]; do sleep .05; done; echo end >>log")
        first = self.start("run")
        while first.poll() is None and not self.log.read_text():
            time.sleep(0.02)
        second = self.start("run")
        waiting = second.stderr.readline()
        (self.root / "go").touch()
        self.assertIn("configuring", first.communicate(timeout=60)[1])
        messages = second.communicate(timeout=60)[1]
        self.assertEqual(waiting, "waterlight: another build goes on in build/release: waiting for its end\n")
        self.assertNotIn("configuring", messages)
        self.assertEqual(self.log.read_text(), "begin\nend\n" * 2)

    def test_a_build_that_fails_is_said_and_nothing_is_run(self):
        self.tool("ninja", "case \" $* \" in *\" -n \"*) exit 0 ;; esac; exit 1")
        status, output, messages = self.finish("run")
        self.assertEqual((status, output), (3, ""))
        self.assertIn("waterlight: building failed", messages)

    def test_what_is_built_is_run_without_a_lock(self):
        self.finish("run")
        self.tool("ninja", "echo 'ninja: no work to do.'")
        lock = self.root / "build/release.lock"
        lock.unlink()
        lock.mkdir()
        status, output, messages = self.finish("run")
        self.assertEqual((status, output, messages), (5, "the program: run\n", ""))

    def test_packages_that_cannot_be_installed_are_said_and_nothing_is_built(self):
        self.tool("dpkg-query", "exit 1")
        self.tool("sudo", "exec \"$@\"")
        status, output, messages = self.finish("run")
        self.assertEqual((status, output, self.log.read_text()), (3, "", ""))
        self.assertIn("apt-get failed", messages)
        self.assertIn("libvtk9-dev", messages)

    def test_fuzz_refuses_a_reader_that_there_is_not(self):
        for arguments in ([], ["esri"], ["other", "5"]):
            status, _, messages = self.finish("fuzz", *arguments)
            self.assertEqual((status, messages), (2, "waterlight: usage: ./waterlight fuzz READER|all SECONDS; readers: esri\n"))


unittest.main(verbosity=2)
