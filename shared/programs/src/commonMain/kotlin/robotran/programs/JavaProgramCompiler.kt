package robotran.programs

import robotran.javacompiler.CompilationResult
import robotran.javacompiler.CompilerNotLoadedException
import robotran.javacompiler.JavaCompiler
import robotran.javacompiler.TimedJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.languagesupport.SourceFile
import robotran.languagesupport.simpleName
import robotran.programs.messages.ProgramMessages
import robotran.tinyvm.diagnostic.LinkError
import kotlin.coroutines.cancellation.CancellationException

/** Compiles and links Java programs. */
internal class JavaProgramCompiler(
    private val compiler: JavaCompiler,
    private val linker: ProgramLinker,
    private val library: JavaLibrary,
) {
    fun read(source: Program): ProgramResult = link(compile(source))

    /** Links what [compile] has compiled. */
    fun link(compiled: CompiledSource): ProgramResult = linked(compiled, linker)

    fun compile(source: Program): CompiledSource =
        compiledOf(source, compiler.compile(source.files, library.classFiles, library.missing, library.target))
}

/**
 * The same with a compiler that works beside the caller and within a time limit, where the platform has one. A program
 * with which it is not ready by then has a mistake that says so.
 */
internal class TimedJavaProgramCompiler(
    private val loaded: LoadedJava,
    private val linker: ProgramLinker,
    private val library: JavaLibrary,
    private val language: Language,
) {
    private val messages = JavaMessages.of(language)

    /** @throws CompilerNotLoadedException see [compile]. */
    suspend fun read(source: Program): ProgramResult = link(compile(source))

    /** Links what [compile] has compiled. */
    fun link(compiled: CompiledSource): ProgramResult = linked(compiled, linker)

    /** @throws CompilerNotLoadedException if the compiler cannot be loaded. */
    suspend fun compile(source: Program): CompiledSource {
        try {
            loaded.timedCompiler?.let { return compiled(source, it.withLanguage(messages)) }
        } catch (_: CompilerNotLoadedException) {
            // A page that may not have this worker compiles by itself.
        }
        return JavaProgramCompiler(ownCompiler().withLanguage(messages), linker, library).compile(source)
    }

    private suspend fun ownCompiler(): JavaCompiler = try {
        loaded.loadCompiler()
    } catch (cancelled: CancellationException) {
        throw cancelled
    } catch (cause: Throwable) {
        // The exception's type depends on the platform.
        throw CompilerNotLoadedException(cause.message.orEmpty(), cause)
    }

    private suspend fun compiled(source: Program, compiler: TimedJavaCompiler): CompiledSource {
        val result = compiler.compile(source.files, library.classFiles, library.missing, library.target)
        return if (result == null) CompiledSource.Failure(listOf(tooLong(source))) else compiledOf(source, result)
    }

    private fun tooLong(source: Program) = Diagnostic(
        Severity.ERROR,
        source.files.firstOrNull()?.name.orEmpty(),
        null,
        ProgramMessages.of(language).compilesTooLong(),
    )
}

internal fun linked(compiled: CompiledSource, linker: ProgramLinker): ProgramResult = when (compiled) {
    is CompiledSource.Success -> linker.link(compiled.program)
    is CompiledSource.Failure -> ProgramResult.Failure(compiled.diagnostics)
}

private fun compiledOf(source: Program, result: CompilationResult): CompiledSource = when (result) {
    is CompilationResult.Failure -> CompiledSource.Failure(result.diagnostics)
    is CompilationResult.Success -> compiledOf(source, result)
}

private fun compiledOf(source: Program, compiled: CompilationResult.Success): CompiledSource {
    val first = source.files.firstOrNull()?.name.orEmpty()
    val mainClass =
        mainClassOf(first, compiled.mainClasses)
            ?: return CompiledSource.Failure(listOfNotNull(compiled.missingMain))
    return CompiledSource.Success(
        CompiledProgram(source.name, compiled.classes, mainClass, compiled.warnings) { refusal ->
            diagnosticOf(refusal, fileOf(source.files, refusal))
        },
    )
}

private fun mainClassOf(file: String, candidates: List<String>): String? {
    val expected = simpleName(file).removeSuffix(".java")
    return candidates.firstOrNull { it.substringAfterLast('/') == expected } ?: candidates.firstOrNull()
}

/** The file that [refusal] is about, or else the first file. */
private fun fileOf(files: List<SourceFile>, refusal: LinkError): String? =
    (files.firstOrNull { simpleName(it.name) == refusal.sourceFile } ?: files.firstOrNull())?.name
