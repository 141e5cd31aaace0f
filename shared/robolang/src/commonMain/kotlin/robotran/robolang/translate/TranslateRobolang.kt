package robotran.robolang.translate

import robotran.robolang.RobolangProgram

/**
 * Translates [program] to Java for its brick: one class, named after the program, which makes the interpreter's calls
 * in the same order. For an RCX it is Java for leJOS 2.1 or 3.0, in the language of JDK 1.3, without features that the
 * brick's virtual machine rejects; for an NXT it is Java for leJOS NXJ 0.9. The figures of the robot are at its top.
 */
fun translateRobolang(program: RobolangProgram): Translation {
    val className = classNameOf(program.name)
    val writer = JavaClass(program, className).write()
    return Translation(className, writer.text, writer.lineMap, program.kind)
}
