package robotran.javacompiler.support

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.javacompiler.edit.isJavaName
import robotran.javacompiler.edit.renamedInJava
import robotran.language.ProgramLanguage
import robotran.languagesupport.BrickMention
import robotran.languagesupport.NewFile
import robotran.languagesupport.ProgramFiles
import robotran.languagesupport.SourceFile
import robotran.languagesupport.uniqueName

/** A file is called like the class in it. */
internal object JavaFiles : ProgramFiles(ProgramLanguage.JAVA) {
    private val extension = ProgramLanguage.JAVA.extension

    override val isNamedByContent get() = true

    override fun namedByContent(file: SourceFile, stem: String): SourceFile = namedByClass(file, stem)

    override fun canStart(text: String): Boolean = hasMain(text)

    override fun nameFor(subject: String): String = super.nameFor(subject.replaceFirstChar { it.uppercase() })

    override fun isValidName(bare: String): Boolean = isJavaName(bare)

    override fun newProgram(name: String, brick: BrickKind): String = firstJava(name.removeSuffix(extension), brick)

    override fun newFile(files: List<SourceFile>, brick: BrickKind): NewFile {
        val name = uniqueName("Helper", extension, files.map { it.name })
        val library = javaOf(brickOf(files) ?: brick).mainPackage
        val text = "import $library.*;\n\nclass ${name.removeSuffix(extension)} {\n\n}\n"
        return NewFile(SourceFile(name, text))
    }

    /** All are one program. */
    override fun programsOf(files: List<SourceFile>): List<List<SourceFile>> =
        if (files.isEmpty()) emptyList() else listOf(files)

    override fun renamed(text: String, old: String, new: String): String =
        renamedInJava(text, old.removeSuffix(extension), new.removeSuffix(extension))

    override fun wrapped(example: String, name: String, brick: BrickKind): String = buildString {
        for (library in importsFor(brick)) append("import $library.*;\n")
        append("\npublic class ${name.removeSuffix(extension)} {\n")
        append("    public static void main(String[] args) throws InterruptedException {\n")
        for (line in example.trimEnd().lines()) append("        ").append(line).append('\n')
        append("    }\n}\n")
    }

    override fun brickOf(files: List<SourceFile>): BrickKind? = brickMentionIn(files)?.kind

    override fun likelyBrickOf(files: List<SourceFile>): BrickKind? =
        brickOf(files) ?: BrickKind.with(JavaPlatform.NXJ).takeIf { looksLikeNxj(files) }

    override fun brickMentionIn(files: List<SourceFile>): BrickMention? = mentionOfBrickIn(files)
}

private fun javaOf(brick: BrickKind) = checkNotNull(brick.java) { "No Java runs on ${brick.name}." }

private fun importsFor(brick: BrickKind): List<String> = when (val java = javaOf(brick)) {
    JavaPlatform.LEJOS -> listOf(java.mainPackage)
    JavaPlatform.NXJ -> listOf(java.mainPackage, "lejos.robotics.navigation", "lejos.util")
}

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
