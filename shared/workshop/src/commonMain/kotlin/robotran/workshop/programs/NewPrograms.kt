package robotran.workshop.programs

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.language.ProgramLanguage
import robotran.programs.brickOf
import robotran.workshop.platform.FileKind
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram

/** A new program in [language] for a [brick] whose name differs from all [others]. */
internal fun newProgram(language: ProgramLanguage, others: List<PupilProgram>, brick: BrickKind): PupilProgram {
    val taken = others.flatMap { it.files }.map { it.name }
    return when (language) {
        ProgramLanguage.ROBOLANG -> PupilProgram(uniqueName("program", language, taken), "")

        ProgramLanguage.JAVA -> uniqueName("Program", language, taken).let {
            PupilProgram(it, firstJava(it.removeSuffix(language.extension), brick))
        }

        ProgramLanguage.NQC -> PupilProgram(uniqueName("program", language, taken), FIRST_NQC)
        ProgramLanguage.LASM -> PupilProgram(uniqueName("program", language, taken), FIRST_LASM)
    }
}

/** A file with another class for the Java program [program] of a robot with a [brick]. */
internal fun newClass(program: PupilProgram, brick: BrickKind): ProgramFile {
    val name = uniqueName("Helper", ProgramLanguage.JAVA, program.files.map { it.name })
    val library = javaOf(brickOf(program.source()) ?: brick).mainPackage
    val className = name.removeSuffix(ProgramLanguage.JAVA.extension)
    return ProgramFile(name, "import $library.*;\n\nclass $className {\n\n}\n")
}

/** A file with functions for the NQC program [program]. */
internal fun newHeader(program: PupilProgram): ProgramFile = ProgramFile(
    uniqueName("helper", FileKind.NQC_HEADER.extension, program.files.map { it.name }),
    "void help()\n{\n\n}\n",
)

/** The file name [name], with a number if it is one of [taken]. */
internal fun uniqueName(name: String, language: ProgramLanguage, taken: List<String>): String =
    uniqueName(name, language.extension, taken)

private fun uniqueName(name: String, ending: String, taken: List<String>): String =
    generateSequence(1) { it + 1 }.map { if (it == 1) "$name$ending" else "$name$it$ending" }.first { it !in taken }

/** Drives for one second: after two, the robot would be at the edge of the plain sheet. */
private val FIRST_NQC = """
    task main()
    {
        OnFwd(OUT_A + OUT_C);
        Wait(100);
        Off(OUT_A + OUT_C);
    }
""".trimIndent()

/** The same in the commands that the firmware runs. */
private val FIRST_LASM = listOf(
    "\ttask\t0",
    "\tdir\t2, 5 ",
    "\tout\t5, 2 ",
    "\twait\t2, 100 ",
    "\tout\t5, 1 ",
    "\tendt",
).joinToString("\n", postfix = "\n")

private fun javaOf(brick: BrickKind) = checkNotNull(brick.java) { "No Java runs on ${brick.name}." }

private fun firstJava(className: String, brick: BrickKind) = when (javaOf(brick)) {
    JavaPlatform.LEJOS -> firstLejos(className)
    JavaPlatform.NXJ -> firstNxj(className)
}

private fun firstNxj(className: String) = """
    import lejos.nxt.*;
    import lejos.util.Delay;

    public class $className {
        public static void main(String[] args) {
            Motor.A.forward();
            Motor.C.forward();
            Delay.msDelay(2000);
            Motor.A.stop(true);
            Motor.C.stop();
        }
    }
    """.trimIndent()

private fun firstLejos(className: String) = """
    import josx.platform.rcx.*;

    public class $className {
        public static void main(String[] args) throws InterruptedException {
            Motor.A.forward();
            Motor.C.forward();
            Thread.sleep(2000);
            Motor.A.stop();
            Motor.C.stop();
        }
    }
    """.trimIndent()
