package robotran.programs

import robotran.language.ProgramLanguage
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.lejoslinker.ImageResult
import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.messages.LinkMessages

/** Builds one image of several programs. */
internal class ImageBuilder(
    private val compilerOf: (ProgramLanguage) -> LanguageCompiler,
    private val java: TimedJavaProgramCompiler,
    private val linker: ClassFileLinker,
    private val messages: LinkMessages,
) {
    /** @throws robotran.javacompiler.CompilerNotLoadedException if the Java compiler cannot be loaded. */
    suspend fun build(sources: List<ProgramSource>): ImageBuildResult {
        val compiled = sources.map { compile(it) }
        val errors = compiled.filterIsInstance<CompiledSource.Failure>().flatMap { it.diagnostics }
        if (errors.isNotEmpty()) return ImageBuildResult.Failure(errors)
        val programs = compiled.map { (it as CompiledSource.Success).program }
        // The image's linker does not look whether code is sound, and a brick even less; the simulated brick's does.
        val unsound = programs.flatMap { (linker.link(it) as? ProgramResult.Failure)?.diagnostics.orEmpty() }
        if (unsound.isNotEmpty()) return ImageBuildResult.Failure(unsound)
        val clashes = clashesOf(programs)
        if (clashes.isNotEmpty()) return ImageBuildResult.Failure(clashes)
        return linkTogether(programs)
    }

    private fun linkTogether(programs: List<CompiledProgram>): ImageBuildResult {
        val classFiles = programs.fold(emptyMap<String, ByteArray>()) { all, each -> all + each.classFiles }
        val mainClasses = programs.map { program ->
            program.mainClass ?: when (val alone = linker.linkImage(program.classFiles, emptyList())) {
                is ImageResult.Success -> alone.image.entryClasses.single()
                is ImageResult.Failure -> return ImageBuildResult.Failure(program.diagnosticsOf(alone.errors))
            }
        }
        return when (val image = linker.linkImage(classFiles, mainClasses)) {
            is ImageResult.Failure -> {
                ImageBuildResult.Failure(image.errors.map { ownerOf(it, programs).locate(it) }.distinct())
            }

            is ImageResult.Success -> {
                val room = image.warnings.map { Diagnostic(Severity.WARNING, programs.first().name, null, it) }
                ImageBuildResult.Success(image.image, programs.flatMap { it.warnings } + room)
            }
        }
    }

    private suspend fun compile(source: ProgramSource): CompiledSource = when (source) {
        is ProgramSource.CompiledClasses -> CompiledSource.Success(compiledOf(source))
        is ProgramSource.FirmwareImage -> error("${source.name} is not for leJOS.")
        is Program -> compilerOf(source.language).compileToClasses(source) { java }
    }

    /** Classes of different programs with the same name; the same class may be in several. */
    private fun clashesOf(programs: List<CompiledProgram>): List<Diagnostic> {
        val seen = HashMap<String, ByteArray>()
        return programs.flatMap { program ->
            program.classFiles.filter { (name, bytes) ->
                seen.getOrPut(name) { bytes }.let { it !== bytes && !it.contentEquals(bytes) }
            }.keys.map { name ->
                val simpleName = name.removeSuffix(".class").replace('/', '.')
                program.locate(LinkError(messages.duplicateClass(simpleName), simpleName))
            }
        }
    }

    private fun ownerOf(error: LinkError, programs: List<CompiledProgram>): CompiledProgram {
        val name = error.className.replace('.', '/')
        return programs.find { name in it.classFiles || "$name.class" in it.classFiles } ?: programs.first()
    }
}
