package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test
import org.jetbrains.compose.ComposePlugin.DesktopDependencies
import org.jetbrains.kotlin.gradle.ExperimentalKotlinGradlePluginApi
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import robotran.build.messages.Messages

/**
 * A module of Compose UI for the JVM, wasm and Android.
 *
 * Its tests run on the JVM only, since Skiko, the renderer of Compose, does not load in Node.
 */
class ComposePlugin : Plugin<Project> {
    @OptIn(ExperimentalWasmDsl::class)
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.multiplatform")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply("org.jetbrains.compose")
        val libraries = catalog(project)
        val targets = Targets.of(project)
        if (targets.android) project.pluginManager.apply("robotran.android.library")
        project.extensions.configure(KotlinMultiplatformExtension::class.java) { kotlin ->
            shareCodeBetweenJvmAndAndroid(kotlin)
            if (targets.jvm) kotlin.jvm()
            if (targets.wasm) kotlin.wasmJs { browser { testTask { it.enabled = false } } }
            if (targets.android) kotlin.androidTarget()
            declareSourceSets(kotlin, "jvmMain", "jvmTest", "androidMain")
            Messages.register(project, "src/commonMain/messages")?.let {
                kotlin.sourceSets.getByName("commonMain").kotlin.srcDir(it)
            }
            kotlin.sourceSets.getByName("jvmTest").dependencies {
                implementation(kotlin("test"))
                implementation(libraries.findLibrary("coroutines-swing").get())
                implementation(libraries.findLibrary("coroutines-test").get())
                implementation(libraries.findLibrary("compose-ui-test").get())
                implementation(DesktopDependencies.currentOs)
            }
        }
        if (targets.wasm) project.pluginManager.apply("robotran.wasm")
        project.tasks.withType(Test::class.java).configureEach { test ->
            test.useJUnitPlatform()
            PropertyTests.configure(project, test)
            test.environment("SKIKO_RENDER_API", "SOFTWARE")
            test.systemProperty("java.awt.headless", "true")
            // A limit of time in a screen's coroutine ends on the event thread, on which its tests run, not on one of its own.
            test.systemProperty("kotlinx.coroutines.main.delay", "true")
            // The UI uses the system language by default; the tests expect English.
            test.systemProperty("user.language", "en")
            // `-PrecordPictures` saves the screenshots of the tests as the new reference images.
            if (project.hasProperty("recordPictures")) test.systemProperty("robotran.recordPictures", "true")
            TestFolders.givePictures(project, test, ReviewPictures.folder(test))
        }
        if (targets.jvm) {
            ReviewPictures.register(project)
            TestParts.registerThorough(project, "jvmTest")
            Rings.addToQuick(project, "jvmTest")
        }
    }

    /** `jvmAndAndroidMain`: code that needs only Java's library. */
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
