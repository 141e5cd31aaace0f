package robotran.programs

import robotran.javacompiler.CompilationResult
import robotran.javacompiler.JavaCompiler
import robotran.javacompiler.TimedJavaCompiler
import robotran.javacompiler.diagnose.JavaDiagnostic
import robotran.javacompiler.diagnose.JavaRange
import robotran.javacompiler.ecj.JavaSource
import robotran.robolang.diagnostic.SourceFix
import robotran.robolang.diagnostic.SourceRange
import robotran.tinyvm.diagnostic.LinkError

/** Compiles and links Java programs. */
internal class JavaProgramCompiler(
    private val compiler: JavaCompiler,
    private val linker: ProgramLinker,
    private val library: JavaLibrary,
) {
    fun read(source: ProgramSource.Java): ProgramResult = link(compile(source))

    /** Links what [compile] has compiled. */
    fun link(compiled: CompiledSource): ProgramResult = linked(compiled, linker)

    fun compile(source: ProgramSource.Java): CompiledSource =
        compiledOf(source, compiler.compile(filesOf(source), library.classFiles, library.missing, library.target))
}

/** The same with a compiler that works beside the caller. */
internal class TimedJavaProgramCompiler(
    private val compiler: TimedJavaCompiler,
    private val linker: ProgramLinker,
    private val library: JavaLibrary,
) {
    /** The result; null if compiling takes too long. */
    suspend fun read(source: ProgramSource.Java): ProgramResult? {
        val result =
            compiler.compile(filesOf(source), library.classFiles, library.missing, library.target) ?: return null
        return linked(compiledOf(source, result), linker)
    }
}

private fun filesOf(source: ProgramSource.Java) = source.files.map { JavaSource(it.name, it.text) }

private fun linked(compiled: CompiledSource, linker: ProgramLinker): ProgramResult = when (compiled) {
    is CompiledSource.Compiled -> linker.link(compiled.program)
    is CompiledSource.HasErrors -> ProgramResult.HasErrors(compiled.diagnostics)
}

private fun compiledOf(source: ProgramSource.Java, result: CompilationResult): CompiledSource = when (result) {
    is CompilationResult.Rejected -> CompiledSource.HasErrors(result.diagnostics.map(::diagnosticOf))
    is CompilationResult.Compiled -> compiledOf(source, result)
}

private fun compiledOf(source: ProgramSource.Java, compiled: CompilationResult.Compiled): CompiledSource {
    val first = source.files.firstOrNull()?.name.orEmpty()
    val mainClass =
        mainClassOf(first, compiled.mainClasses)
            ?: return CompiledSource.HasErrors(listOfNotNull(compiled.missingMain?.let(::diagnosticOf)))
    val warnings = compiled.warnings.map(::diagnosticOf)
    return CompiledSource.Compiled(
        CompiledProgram(source.name, compiled.classes, mainClass, warnings) { refusal ->
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

private fun diagnosticOf(diagnostic: JavaDiagnostic) = ProgramDiagnostic(
    diagnostic.path,
    rangeOf(diagnostic.range),
    listOfNotNull(diagnostic.message, diagnostic.hint).joinToString(" "),
    diagnostic.fix?.let { SourceFix(rangeOf(it.range), it.replacement) },
)

private fun rangeOf(range: JavaRange) = SourceRange(range.line, range.column, range.endColumn)
