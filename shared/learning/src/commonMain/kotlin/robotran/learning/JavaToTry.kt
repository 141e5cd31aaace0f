package robotran.learning

/** Wraps [lines] of Java, such as the example of a [WordHelp], in a whole program for the file `Try.java`. */
fun wrapJavaExample(lines: String): String = buildString {
    append(
        "import josx.platform.rcx.*;\n\npublic class Try {\n    public static void main(String[] args) throws " +
            "InterruptedException {\n",
    )
    for (line in lines.trimEnd().lines()) append("        ").append(line).append('\n')
    append("    }\n}\n")
}
