package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test
import org.jetbrains.compose.ComposePlugin.DesktopDependencies
import org.jetbrains.kotlin.gradle.ExperimentalKotlinGradlePluginApi
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/**
 * A module of Compose screens for the JVM, wasm and, where the module applies an Android library plugin before this
 * one, Android.
 *
 * Its tests run on the JVM only: Skiko, which Compose draws with, does not load in Node.
 */
class ComposePlugin : Plugin<Project> {
    @OptIn(ExperimentalWasmDsl::class)
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.multiplatform")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply("org.jetbrains.compose")
        val libraries = catalog(project)
        project.extensions.configure(KotlinMultiplatformExtension::class.java) { kotlin ->
            shareCodeBetweenJvmAndAndroid(kotlin)
            kotlin.jvm()
            kotlin.wasmJs { browser { testTask { it.enabled = false } } }
            project.pluginManager.withPlugin("com.android.library") { kotlin.androidTarget() }
            kotlin.sourceSets.getByName("jvmTest").dependencies {
                implementation(kotlin("test"))
                implementation(libraries.findLibrary("coroutines-test").get())
                implementation(libraries.findLibrary("compose-ui-test").get())
                implementation(DesktopDependencies.currentOs)
            }
        }
        WebTools.use(project)
        project.tasks.withType(Test::class.java).configureEach { test ->
            test.useJUnitPlatform()
            PropertyTests.configure(project, test)
            test.environment("SKIKO_RENDER_API", "SOFTWARE")
            test.systemProperty("java.awt.headless", "true")
            // The screen speaks the machine's language unless it is told another; tests read it in English.
            test.systemProperty("user.language", "en")
            // `-PrecordPictures` keeps the pictures that the tests make as those to be held against from now on.
            if (project.hasProperty("recordPictures")) test.systemProperty("robotran.recordPictures", "true")
            test.systemProperty("robotran.pictures", project.layout.buildDirectory.dir("pictures").get().asFile.path)
        }
    }

    /** `jvmAndAndroidMain`: what needs Java's library and no more. */
    @OptIn(ExperimentalKotlinGradlePluginApi::class)
    private fun shareCodeBetweenJvmAndAndroid(kotlin: KotlinMultiplatformExtension) {
        kotlin.applyDefaultHierarchyTemplate {
            common {
                group("jvmAndAndroid") {
                    withJvm()
                    withAndroidTarget()
                }
            }
        }
    }
}
