package robotran.build.teavm

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/**
 * Lays the files that a [TeaVmPlugin] module has for the browser beside the generated JavaScript, where the Kotlin code
 * imports them from. Kotlin hands a module's resources to its own executables and tests but not to the modules that use
 * it, so every module that links that code into a wasm test or executable applies the plugin too.
 *
 * @param module the path of the module in the build.
 */
abstract class WebFilesPlugin(private val module: String) : Plugin<Project> {
    override fun apply(project: Project) {
        val files = TeaVmPlugin.toolConfiguration(project, module.substringAfterLast(':') + "WebFiles")
        project.dependencies.add(
            files.name,
            project.dependencies.project(mapOf("path" to module, "configuration" to TeaVmPlugin.WEB_FILES)),
        )
        project.pluginManager.withPlugin("org.jetbrains.kotlin.multiplatform") {
            val kotlin = project.extensions.getByType(KotlinMultiplatformExtension::class.java)
            kotlin.sourceSets.matching { it.name == "wasmJsMain" }.configureEach { it.resources.srcDir(files) }
        }
    }
}
