package robotran.workshop.send

import kotlinx.coroutines.withContext
import robotran.programs.ImageBuildResult
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.programs.firmwareImage
import robotran.projects.PENBOT_TARGET
import robotran.tinyvm.config.BrickRoom
import robotran.workshop.service.Services
import kotlin.coroutines.cancellation.CancellationException

/** Builds images for the firmware that a program is for; those for leJOS as the project's settings for Java say. */
internal class ProgramImageBuilder(services: Services) : ImageBuilder {
    private val platform = services.platform
    private val preferences = services.preferences
    private val current = services.current

    override suspend fun build(program: Program): ProgramImageResult {
        val compiler = ProgramCompiler(PENBOT_TARGET, current.project.settings.java, preferences.language)
        val source = program
        return try {
            withContext(platform.background) {
                if (source.isForLegoFirmware) compiler.forLego(source) else compiler.forLejos(source)
            }
        } catch (cancelled: CancellationException) {
            throw cancelled
        } catch (_: Throwable) {
            // A bug of the compiler must not take the app with it.
            ProgramImageResult.CompilerFailed
        }
    }

    private suspend fun ProgramCompiler.forLejos(source: ProgramSource) =
        when (val built = buildImage(listOf(source))) {
            is ImageBuildResult.Success -> ProgramImageResult.Success(BuiltProgram.Lejos(built.image.bytes, maxBytes()))
            is ImageBuildResult.Failure -> ProgramImageResult.Failure(built.diagnostics)
            is ImageBuildResult.NotLoaded -> ProgramImageResult.NoCompiler
        }

    private fun ProgramCompiler.forLego(source: ProgramSource) = when (val compiled = compileNow(source)) {
        is ProgramResult.Success -> {
            val image = checkNotNull(compiled.firmwareImage) { "${source.name} is not for LEGO's firmware." }
            ProgramImageResult.Success(BuiltProgram.Lego(image))
        }

        is ProgramResult.Failure -> ProgramImageResult.Failure(compiled.diagnostics)
    }

    private fun maxBytes(): Int = BrickRoom.of(current.project.settings.java.version).maxImageBytes
}
