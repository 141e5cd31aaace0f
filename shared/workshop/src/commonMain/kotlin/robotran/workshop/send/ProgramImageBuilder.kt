package robotran.workshop.send

import kotlinx.coroutines.withContext
import robotran.programs.CompilerLoading
import robotran.programs.ImageBuildResult
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramSource
import robotran.projects.PENBOT_TARGET
import robotran.tinyvm.config.BrickRoom
import robotran.workshop.platform.Platform
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Preferences
import robotran.workshop.state.PupilProgram
import kotlin.coroutines.cancellation.CancellationException

/** Builds images as the project's settings for Java say. */
internal class ProgramImageBuilder(
    private val platform: Platform,
    private val preferences: Preferences,
    private val current: CurrentProject,
) : ImageBuilder {
    override suspend fun build(program: PupilProgram): ProgramImageResult {
        val compiler = ProgramCompiler(PENBOT_TARGET, current.project.settings.java, preferences.language)
        // Robolang becomes Java first, so both languages need its compiler.
        val loading = compiler.prepareFor(ProgramSource.Java(program.name, emptyList()))
        if (loading is CompilerLoading.Failed) return ProgramImageResult.NoCompiler
        return try {
            when (val built = withContext(platform.background) { compiler.buildImage(listOf(program.source())) }) {
                is ImageBuildResult.Built -> ProgramImageResult.Ready(built.image.bytes, maxBytes())
                is ImageBuildResult.HasErrors -> ProgramImageResult.HasErrors(built.diagnostics)
            }
        } catch (cancelled: CancellationException) {
            throw cancelled
        } catch (_: Throwable) {
            // A bug of the compiler must not take the app with it.
            ProgramImageResult.CompilerFailed
        }
    }

    private fun maxBytes(): Int = BrickRoom.of(current.project.settings.java.version).maxImageBytes
}
