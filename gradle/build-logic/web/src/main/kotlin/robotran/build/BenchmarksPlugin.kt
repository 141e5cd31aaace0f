package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.JavaExec
import org.jetbrains.compose.ComposePlugin.DesktopDependencies
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/** Benchmarks on the JVM (`run`) and in Chromium (`runInBrowser`), started by hand. `check` only compiles them. */
class BenchmarksPlugin : Plugin<Project> {
    @OptIn(ExperimentalWasmDsl::class)
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.multiplatform")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply("robotran.physics-web")
        project.pluginManager.apply("robotran.ecj-web")
        val kotlin = project.extensions.getByType(KotlinMultiplatformExtension::class.java)
        val jvm = kotlin.jvm().compilations.getByName("main")
        kotlin.wasmJs {
            outputModuleName.set("benchmarks")
            browser {
                commonWebpackConfig { it.outputFileName = "benchmarks.js" }
                testTask { it.enabled = false }
            }
            binaries.executable()
        }
        kotlin.sourceSets.getByName("jvmMain").dependencies { implementation(DesktopDependencies.currentOs) }
        WasmOptimisation.use(project, WasmOptimisation.RELEASE_PASSES)
        WebTools.use(project)
        leaveOutOfCheck(project, "allTests", "wasmJsBrowserTest")
        val jvmClasses = project.files(jvm.output.allOutputs, jvm.runtimeDependencyFiles)
        project.tasks.register("run", JavaExec::class.java) { task ->
            task.description = "Measures on the JVM."
            task.mainClass.set(JVM_MAIN)
            task.classpath(jvmClasses)
            task.systemProperty("java.awt.headless", "true")
        }
        project.tasks.register("runInBrowser", BrowserBenchmark::class.java) { task ->
            task.description = "Measures on the JVM and in headless Chromium."
            task.jvmClasses.from(jvmClasses)
            task.jvmMain.set(JVM_MAIN)
            task.names.set(project.providers.gradleProperty("benchmarks").map { it.split(",") }.orElse(emptyList()))
            task.page.fileProvider(project.tasks.named("wasmJsBrowserDistribution").map { it.outputs.files.singleFile })
            task.driver.set(project.file("src/browser/measure.mjs"))
        }
        project.tasks.named("check") { it.dependsOn(jvm.compileTaskProvider, "compileKotlinWasmJs") }
    }

    private companion object {
        const val JVM_MAIN = "robotran.benchmarks.MainKt"
    }
}
