package robotran.robolang.translate

import robotran.robolang.RobolangProgram

/**
 * Writes [program] as Java for leJOS RCX 2.1 or 3.0: one class, named after the program, in the Java of JDK 1.3 and
 * with nothing that the brick's small virtual machine refuses. Compiled and run it makes the ROM calls that the
 * interpreter makes, in the same order. The calibration that the program was read with stands at its top.
 */
fun translateRobolang(program: RobolangProgram): Translation {
    val className = classNameOf(program.name)
    val writer = JavaClass(program, className).write()
    return Translation(className, writer.text, writer.lineMap)
}
