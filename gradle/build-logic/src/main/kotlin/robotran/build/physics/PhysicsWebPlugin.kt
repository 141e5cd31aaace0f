package robotran.build.physics

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/**
 * For every module that links `shared/world` into a wasm test or executable: lays the physics module (`physics.mjs` and what it loads)
 * beside the generated JavaScript, where `loadPhysicsEngine()` imports it from. Kotlin hands a module's
 * resources to its own executables and tests but not to the modules that use it, so each of them applies `id("robotran.physics-web")`.
 */
class PhysicsWebPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val files = project.configurations.create("physicsWebFiles") {
            it.isCanBeConsumed = false
            it.isCanBeResolved = true
        }
        val physics = project.dependencies.project(mapOf("path" to ":shared:physics", "configuration" to PhysicsPlugin.WEB_FILES))
        project.dependencies.add(files.name, physics)
        project.pluginManager.withPlugin("org.jetbrains.kotlin.multiplatform") {
            val kotlin = project.extensions.getByType(KotlinMultiplatformExtension::class.java)
            kotlin.sourceSets.matching { it.name == "wasmJsMain" }.configureEach { it.resources.srcDir(files) }
        }
    }
}
