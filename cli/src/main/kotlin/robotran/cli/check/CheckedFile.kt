package robotran.cli.check

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.cli.files.CLASS
import robotran.cli.files.JAR
import robotran.cli.files.JAVA
import robotran.cli.files.NamedProgram
import robotran.cli.files.ProgramFiles
import robotran.cli.files.RCX_IMAGE
import robotran.cli.files.ROBOLANG
import robotran.cli.files.TextFile
import robotran.cli.files.isFolder
import robotran.cli.files.isNamed
import robotran.cli.files.readJavaFile
import robotran.cli.files.readProgramFiles
import robotran.cli.input.RobolangFile
import robotran.cli.input.isCourse
import robotran.cli.input.readRobolangFile
import robotran.cli.messages.CommandMessages
import robotran.json.JsonWarning
import robotran.language.ProgramLanguage
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import robotran.programs.ImageBuildResult
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.programs.likelyBrickOf
import robotran.projects.penbotTarget

/** The result of checking one file. */
internal sealed interface CheckedFile {
    /**
     * A Robolang program.
     *
     * @property translated why a brick cannot run the Java that it becomes.
     * @property isForBrick whether it is to run on a real brick, so that these are mistakes rather than remarks.
     */
    data class Robolang(
        val file: RobolangFile,
        val translated: List<Diagnostic> = emptyList(),
        val isForBrick: Boolean = false,
    ) : CheckedFile {
        val canRun: Boolean get() = file is RobolangFile.Ready && !(isForBrick && translated.isNotEmpty())
        override val notes: List<String> get() = file.notes
    }

    /**
     * One file of a Java program, or all class files of one.
     *
     * @property isCompiled whether it is the latter; diagnostics then name class and method as their file.
     */
    data class Java(
        val diagnostics: List<Diagnostic>,
        val warnings: List<Diagnostic>,
        val isCompiled: Boolean = false,
        override val notes: List<String> = emptyList(),
    ) : CheckedFile

    /** A program for LEGO's own firmware, with all files that it includes. */
    data class Firmware(
        val program: NamedProgram,
        val diagnostics: List<Diagnostic>,
        val warnings: List<Diagnostic>,
        override val notes: List<String> = emptyList(),
    ) : CheckedFile

    /**
     * A world, a robot, a project or a course.
     *
     * @property error why it cannot be used, with its line; null if it can.
     */
    data class Described(
        val error: JsonWarning?,
        val warnings: List<JsonWarning>,
        override val notes: List<String> = emptyList(),
    ) : CheckedFile

    /** The file cannot be read. [reason] is a sentence that names the file. */
    data class Unreadable(val reason: String) : CheckedFile

    /** How the file was read although it is unusual, in sentences. */
    val notes: List<String> get() = emptyList()
}

/**
 * Checks the files [names] in order: each `.robo`, `.nqc`, `.lasm` and `.rcx` file, jar and folder of class files on its
 * own, all `.java` files together as one program, and so all `.class` files, for which the first one stands. Worlds,
 * robots, projects and courses are known by their content.
 *
 * @param compiler has the settings of an RCX that Java is for.
 * @param brick that programs are for; null for the one that each names, otherwise an RCX.
 * @param isForBrick whether Robolang programs are to run on a real brick.
 */
internal fun checkFiles(
    names: List<String>,
    compiler: ProgramCompiler,
    brick: BrickKind?,
    isForBrick: Boolean,
): List<Pair<String, CheckedFile>> {
    val java = checkJava(names.filter { isNamed(it, JAVA) }.distinct(), compiler, brick)
    val classes = names.filter { isNamed(it, CLASS) }.distinct()
    return (names - classes.drop(1).toSet()).map { name ->
        name to when {
            name in java -> java.getValue(name)
            isNamed(name, ROBOLANG) -> checkRobolang(name, compiler, brick, isForBrick)
            name in classes -> checkClasses(classes, compiler, brick)
            isOtherProgram(name) -> checkProgram(name, compiler, brick)
            isCourse(name) -> checkCourse(name, compiler.language)
            isNamed(name, JAR) || isFolder(name) -> checkClasses(listOf(name), compiler, brick)
            else -> checkDescription(name, compiler.language)
        }
    }
}

/** Whether [name] is that of a program in one file, besides those that are checked in a way of their own. */
private fun isOtherProgram(name: String): Boolean =
    ProgramLanguage.entries.any { isNamed(name, it.extension) } || isNamed(name, RCX_IMAGE)

/** Checks the program that [names] hold, compiled. */
private fun checkClasses(names: List<String>, compiler: ProgramCompiler, brick: BrickKind?): CheckedFile =
    when (val files = readProgramFiles(names, CommandMessages.of(compiler.language))) {
        is ProgramFiles.Failure -> CheckedFile.Unreadable(files.reason)

        is ProgramFiles.Success -> {
            val program = files.programs.single()
            val result = runBlocking { compiler.forBrickOf(program.source, brick).compileOrThrow(program.source) }
            val diagnostics = (result as? ProgramResult.Failure)?.diagnostics
            CheckedFile.Java(diagnostics.orEmpty(), emptyList(), isCompiled = true)
        }
    }

private fun checkProgram(name: String, compiler: ProgramCompiler, brick: BrickKind?): CheckedFile =
    when (val files = readProgramFiles(listOf(name), CommandMessages.of(compiler.language))) {
        is ProgramFiles.Failure -> CheckedFile.Unreadable(files.reason)

        is ProgramFiles.Success -> {
            val program = files.programs.single()
            val result = runBlocking { compiler.forBrickOf(program.source, brick).compileOrThrow(program.source) }
            CheckedFile.Firmware(
                program,
                (result as? ProgramResult.Failure)?.diagnostics.orEmpty(),
                (result as? ProgramResult.Success)?.warnings.orEmpty(),
                files.notes,
            )
        }
    }

private fun checkRobolang(
    name: String,
    compiler: ProgramCompiler,
    brick: BrickKind?,
    isForBrick: Boolean,
): CheckedFile = when (val file = readRobolangFile(name, compiler.language, brick)) {
    is RobolangFile.Unreadable -> CheckedFile.Unreadable(file.reason)

    is RobolangFile.Ready -> {
        val told = file.copy(warnings = file.warnings + missingOnRobot(file, compiler))
        CheckedFile.Robolang(told, checkTranslation(file, compiler), isForBrick)
    }

    is RobolangFile.HasErrors -> CheckedFile.Robolang(file)
}

/** The mistakes in the Java that [file] becomes, at the lines of [file] where that is possible. */
private fun checkTranslation(file: RobolangFile.Ready, compiler: ProgramCompiler): List<Diagnostic> {
    val source = Program.of(file.program.name, file.source)
    val kind = file.program.kind
    return runBlocking {
        when (kind.java) {
            JavaPlatform.LEJOS -> (compiler.buildImage(listOf(source)) as? ImageBuildResult.Failure)?.diagnostics

            JavaPlatform.NXJ -> compiler.forTarget(kind.penbotTarget).compileTranslation(source)
                .let { it as? ProgramResult.Failure }?.diagnostics

            null -> null
        }
    }.orEmpty()
}

/** What a robot with the brick of [file] does not have and its program needs, where that is told beside the mistakes. */
private fun missingOnRobot(file: RobolangFile.Ready, compiler: ProgramCompiler): List<Diagnostic> {
    if (file.program.kind.java != null) return emptyList()
    val source = Program.of(file.program.name, file.source)
    val result = runBlocking { compiler.forTarget(file.program.kind.penbotTarget).compileOrThrow(source) }
    return (result as? ProgramResult.Success)?.warnings.orEmpty() - file.warnings.toSet()
}

/** This compiler for the penbot with [brick], or if null, with the one that [source] names, otherwise with the default one. */
private fun ProgramCompiler.forBrickOf(source: ProgramSource, brick: BrickKind?): ProgramCompiler =
    forTarget((brick ?: likelyBrickOf(source) ?: BrickKind.default).penbotTarget)

private fun checkJava(names: List<String>, compiler: ProgramCompiler, brick: BrickKind?): Map<String, CheckedFile> {
    val language = compiler.language
    val messages = CommandMessages.of(language)
    val read = names.associateWith { readJavaFile(it, isAlone = names.size == 1, messages) }
    val sources = read.mapNotNull { (_, file) -> (file as? TextFile.Success)?.let { SourceFile(it.name, it.text) } }
    if (sources.isEmpty()) {
        return read.mapValues { (_, file) ->
            CheckedFile.Unreadable((file as TextFile.Failure).reason)
        }
    }
    val source = Program.of(sources)
    val result = runBlocking { compiler.forBrickOf(source, brick).compileOrThrow(source) }
    val diagnostics = byFile((result as? ProgramResult.Failure)?.diagnostics.orEmpty(), sources)
    val warnings = byFile((result as? ProgramResult.Success)?.warnings.orEmpty(), sources)
    return read.mapValues { (_, file) ->
        when (file) {
            is TextFile.Failure -> CheckedFile.Unreadable(file.reason)

            is TextFile.Success -> CheckedFile.Java(
                diagnostics[file.name].orEmpty(),
                warnings[file.name].orEmpty(),
                notes = file.notes,
            )
        }
    }
}

/** A diagnostic that belongs to none of the [sources] goes to the first. */
private fun byFile(described: List<Diagnostic>, sources: List<SourceFile>): Map<String, List<Diagnostic>> =
    described.groupBy { diagnostic ->
        (sources.find { it.name == diagnostic.file } ?: sources.first()).name
    }
