package robotran.build.lejos

import org.gradle.api.Plugin
import org.gradle.api.Project

/**
 * Adds the class files of a module's Java code in `src/brick/java` as the Base64 constant
 * `robotran.lejoslibrary.libraryClasses`. Publishes their folder to other modules, see [BrickProgramsPlugin].
 */
class LejosLibraryPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val sources = project.provider { project.fileTree("src/brick/java") { it.include("**/*.java") } }
        val compile = compileForBrick(project, "compileForBrick", "library", sources, BrickTarget.LEJOS_RCX) {}
        generateClassFiles(project, compile, "robotran.lejoslibrary.libraryClasses", "commonMain")
        publishClasses(project, compile)
    }
}
