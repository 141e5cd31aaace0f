package robotran.robolang.translate

import robotran.robolang.RobolangProgram

/**
 * Translates [program] to Java for leJOS RCX 2.1 or 3.0: one class, named after the program, in the Java of JDK 1.3,
 * without features that the brick's virtual machine rejects. It makes the interpreter's ROM calls in the same order.
 * The program's calibration is at its top.
 */
fun translateRobolang(program: RobolangProgram): Translation {
    val className = classNameOf(program.name)
    val writer = JavaClass(program, className).write()
    return Translation(className, writer.text, writer.lineMap)
}
