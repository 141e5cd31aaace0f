package robotran.robolang

import robotran.robolang.syntax.RobolangLimits

/** Programs of half the max length, of the kinds that take longest to compile. */
internal fun longestPrograms(): List<String> {
    val half = RobolangLimits.SOURCE_CHARACTERS / 2
    return listOf(
        " repeat 1 time\n".repeat(half / 15) + "end\n".repeat(half / 4),
        "repeat 1 time\n".repeat(half / 14) + " end\n".repeat(half / 14 - 1),
        "end\n".repeat(half / 4),
        "9".repeat(half),
        "x".repeat(half),
        "# ".repeat(half),
        "} ".repeat(half),
        "２".repeat(half),
        "“".repeat(half),
        "beep ".repeat(half / 5),
        "\r".repeat(half),
        "show " + "(".repeat(half),
        "show " + "1 + ".repeat(half / 4),
        "show " + "not ".repeat(half / 4),
        "show " + "- ".repeat(half / 2),
        "show x" + "[0]".repeat(half / 3),
        "if true\n".repeat(half / 8) + "else\n".repeat(half / 5),
        "repeat 1 time\nif true\nelse\n".repeat(half / 27),
        "procedure p()\n".repeat(half / 14),
        "var end = 1\n".repeat(half / 24) + "end = 2\n".repeat(half / 16),
        "var start = 1\n" + "show start start\n".repeat(half / 18),
        "show " + "x".repeat(20) + "\nshow y".repeat(half / 7),
        "var x = [" + "1,".repeat(half / 2),
        chainOfRoutines(half / 34) + "p0()\nvar last = 1\nprocedure q()\nshow last\nend",
        List(half / 40) {
            "procedure p$it()\np${it + 1}()\nshow g$it\nend\n"
        }.joinToString("", prefix = globals(half / 40)),
    )
}

private fun chainOfRoutines(count: Int): String = List(count) {
    "procedure p$it()\np${(it + 1) % count}()\nend\n"
}.joinToString("")

private fun globals(count: Int): String = List(count) { "var g$it = 1\n" }.joinToString("")
