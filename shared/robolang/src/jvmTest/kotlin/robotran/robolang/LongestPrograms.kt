package robotran.robolang

/** Programs of [characters], of the kinds that take longest to compile. */
internal fun longestPrograms(characters: Int): List<String> {
    return listOf(
        " repeat 1 time\n".repeat(characters / 15) + "end\n".repeat(characters / 4),
        "repeat 1 time\n".repeat(characters / 14) + " end\n".repeat(characters / 14 - 1),
        "end\n".repeat(characters / 4),
        "9".repeat(characters),
        "x".repeat(characters),
        "# ".repeat(characters),
        "} ".repeat(characters),
        "２".repeat(characters),
        "“".repeat(characters),
        "beep ".repeat(characters / 5),
        "\r".repeat(characters),
        "show " + "(".repeat(characters),
        "show " + "1 + ".repeat(characters / 4),
        "show " + "not ".repeat(characters / 4),
        "show " + "- ".repeat(characters / 2),
        "show x" + "[0]".repeat(characters / 3),
        "if true\n".repeat(characters / 8) + "else\n".repeat(characters / 5),
        "repeat 1 time\nif true\nelse\n".repeat(characters / 27),
        "procedure p()\n".repeat(characters / 14),
        "var end = 1\n".repeat(characters / 24) + "end = 2\n".repeat(characters / 16),
        "var start = 1\n" + "show start start\n".repeat(characters / 18),
        "show " + "x".repeat(20) + "\nshow y".repeat(characters / 7),
        "var x = [" + "1,".repeat(characters / 2),
        chainOfRoutines(characters / 34) + "p0()\nvar last = 1\nprocedure q()\nshow last\nend",
        List(characters / 40) {
            "procedure p$it()\np${it + 1}()\nshow g$it\nend\n"
        }.joinToString("", prefix = globals(characters / 40)),
    )
}

private fun chainOfRoutines(count: Int): String = List(count) {
    "procedure p$it()\np${(it + 1) % count}()\nend\n"
}.joinToString("")

private fun globals(count: Int): String = List(count) { "var g$it = 1\n" }.joinToString("")
