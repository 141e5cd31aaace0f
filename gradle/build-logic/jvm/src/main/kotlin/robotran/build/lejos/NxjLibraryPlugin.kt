package robotran.build.lejos

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import robotran.build.teavm.WEB_FILES

/**
 * Packs the class files and the sources of a module's Java code in `src/brick/java` into two files: resources on the
 * JVM, and files that a page fetches when it needs them, see [WEB_FILES]. They are too large for what a page loads
 * first. Publishes the folder of the class files to other modules, see [BrickProgramsPlugin].
 */
class NxjLibraryPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val sources = project.provider { project.fileTree(SOURCES) { it.include("**/*.java") } }
        val compile = compileForBrick(project, "compileForBrick", "library", sources, BrickTarget.LEJOS_NXJ) {}
        publishClasses(project, compile)
        val pack = project.tasks.register("packLibrary", PackLibrary::class.java) {
            it.classFolder.set(compile.flatMap { compiled -> compiled.classFolder })
            it.sourceFolder.set(project.layout.projectDirectory.dir(SOURCES))
            it.resourceFolder.set(project.layout.buildDirectory.dir("brick/library/resources"))
            it.webFolder.set(project.layout.buildDirectory.dir("brick/library/web"))
        }
        val sourceSets = project.extensions.getByType(KotlinMultiplatformExtension::class.java).sourceSets
        sourceSets.getByName("jvmMain").resources.srcDir(pack.flatMap { it.resourceFolder })
        sourceSets.getByName("wasmJsMain").resources.srcDir(pack.flatMap { it.webFolder })
        project.configurations.create(WEB_FILES) {
            it.isCanBeResolved = false
            it.isCanBeConsumed = true
            it.outgoing.artifact(pack.flatMap { packed -> packed.webFolder })
        }
    }

    private companion object {
        const val SOURCES = "src/brick/java"
    }
}
