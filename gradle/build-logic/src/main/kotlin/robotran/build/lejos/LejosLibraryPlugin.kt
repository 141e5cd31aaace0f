package robotran.build.lejos

import org.gradle.api.Plugin
import org.gradle.api.Project

/**
 * Gives a multiplatform module the class files of its Java in `src/brick/java` as the constant
 * `robotran.lejoslibrary.libraryClasses`, in Base64, and other modules the folder with them, see [BrickProgramsPlugin].
 */
class LejosLibraryPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val sources = project.provider { project.fileTree("src/brick/java") { it.include("**/*.java") } }
        val compile = compileForBrick(project, "compileForBrick", "library", sources) {}
        generateClassFiles(project, compile, "robotran.lejoslibrary.libraryClasses", "commonMain")
        project.configurations.create(BRICK_CLASSES) {
            it.isCanBeConsumed = true
            it.isCanBeResolved = false
            it.outgoing.artifact(compile.flatMap { compiled -> compiled.classFolder })
        }
    }
}
