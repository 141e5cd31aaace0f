package robotran.workshop.programs

import robotran.language.ProgramLanguage
import robotran.workshop.state.ProgramFile
import robotran.workshop.state.PupilProgram

/** A new program in [language] whose name differs from all [others]. */
internal fun newProgram(language: ProgramLanguage, others: List<PupilProgram>): PupilProgram {
    val taken = others.flatMap { it.files }.map { it.name }
    return when (language) {
        ProgramLanguage.ROBOLANG -> PupilProgram(uniqueName("program", language, taken), "")

        ProgramLanguage.JAVA -> uniqueName("Program", language, taken).let {
            PupilProgram(it, firstJava(it.removeSuffix(language.extension)))
        }
    }
}

/** A file with another class for the Java program [program]. */
internal fun newClass(program: PupilProgram): ProgramFile {
    val name = uniqueName("Helper", ProgramLanguage.JAVA, program.files.map { it.name })
    return ProgramFile(
        name,
        "import josx.platform.rcx.*;\n\nclass ${name.removeSuffix(ProgramLanguage.JAVA.extension)} {\n\n}\n",
    )
}

/** The file name [name], with a number if it is one of [taken]. */
internal fun uniqueName(name: String, language: ProgramLanguage, taken: List<String>): String =
    generateSequence(1) { it + 1 }.map {
        if (it == 1) {
            "$name${language.extension}"
        } else {
            "$name$it${language.extension}"
        }
    }.first { it !in taken }

private fun firstJava(className: String) = """
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
