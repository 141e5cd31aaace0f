package robotran.learning

/** A whole program, of the file `Try.java`, around some [lines] of Java, as the examples of [WordHelp] are. */
fun javaToTry(lines: String): String = buildString {
    append(
        "import josx.platform.rcx.*;\n\npublic class Try {\n    public static void main(String[] args) throws " +
            "InterruptedException {\n",
    )
    for (line in lines.trimEnd().lines()) append("        ").append(line).append('\n')
    append("    }\n}\n")
}
