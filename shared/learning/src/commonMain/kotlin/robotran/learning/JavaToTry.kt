package robotran.learning

import robotran.brick.kind.BrickKind

/**
 * Wraps [lines] of Java for a [brick], such as the example of a [WordHelp], in a whole program for the file `Try.java`.
 */
fun wrapJavaExample(lines: String, brick: BrickKind): String = buildString {
    for (name in importsFor(brick)) append("import $name.*;\n")
    append("\npublic class Try {\n    public static void main(String[] args) throws InterruptedException {\n")
    for (line in lines.trimEnd().lines()) append("        ").append(line).append('\n')
    append("    }\n}\n")
}

private fun importsFor(brick: BrickKind): List<String> = when (brick) {
    BrickKind.RCX -> listOf("josx.platform.rcx")
    BrickKind.NXT -> listOf("lejos.nxt", "lejos.robotics.navigation", "lejos.util")
}
