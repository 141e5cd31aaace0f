package robotran.build.teavm

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import robotran.build.Targets

/**
 * Copies the browser files of Java modules next to the generated JavaScript, where Kotlin code imports them.
 * Kotlin passes a module's resources to its own executables and tests only. So every module that links that code into a
 * wasm test or executable must apply this plugin.
 *
 * @param modules the Gradle paths of the modules.
 */
abstract class WebFilesPlugin(private vararg val modules: String) : Plugin<Project> {
    override fun apply(project: Project) {
        if (!Targets.of(project).wasm) return
        modules.forEach { copy(project, it) }
    }

    private fun copy(project: Project, module: String) {
        val files = toolConfiguration(project, module.substringAfterLast(':') + "WebFiles")
        project.dependencies.add(
            files.name,
            project.dependencies.project(mapOf("path" to module, "configuration" to WEB_FILES)),
        )
        project.pluginManager.withPlugin("org.jetbrains.kotlin.multiplatform") {
            val kotlin = project.extensions.getByType(KotlinMultiplatformExtension::class.java)
            kotlin.sourceSets.matching { it.name == "wasmJsMain" }.configureEach { it.resources.srcDir(files) }
        }
    }
}
