package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.provider.Provider
import org.gradle.api.tasks.TaskProvider
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import org.jetbrains.kotlin.gradle.targets.js.ir.KotlinJsIrLink
import org.jetbrains.kotlin.gradle.targets.js.webpack.KotlinWebpack
import robotran.build.site.AssembleSite
import robotran.build.site.CompressSite
import robotran.build.site.OptimizeWasm
import robotran.build.site.ReplaceWasm
import java.io.File

/** The web page: a Kotlin/Wasm executable, its HTML page, the folder for a web server, and tests in a real browser. */
class WebAppPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.multiplatform")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply("org.jetbrains.compose")
        project.pluginManager.apply("robotran.physics-web")
        project.pluginManager.apply("robotran.ecj-web")
        addTarget(project)
        WebTools.use(project)
        leaveOutOfCheck(project, "allTests", "wasmJsBrowserTest")
        val site = addSite(project)
        val browserTest = addBrowserTest(project, site)
        val engineTest = addEngineTest(project)
        // Both need the whole machine.
        engineTest.configure { it.mustRunAfter(browserTest) }
        project.tasks.named("check") { it.dependsOn(browserTest, engineTest) }
        addReleaseTest(project, addRelease(project))
        addMeasuring(project)
    }

    @OptIn(ExperimentalWasmDsl::class)
    private fun addTarget(project: Project) {
        project.extensions.configure(KotlinMultiplatformExtension::class.java) { kotlin ->
            kotlin.wasmJs {
                outputModuleName.set("robotran")
                browser {
                    commonWebpackConfig { it.outputFileName = "robotran.js" }
                    testTask { it.enabled = false }
                }
                binaries.executable()
            }
        }
        WasmOptimisation.use(project, WasmOptimisation.TEST_PASSES)
        // A source map is as large as the code, and needs `eval`.
        project.tasks.withType(KotlinWebpack::class.java).configureEach { it.sourceMaps = false }
    }

    /** `assembleSite`: the site for tests, hardly optimised. */
    private fun addSite(project: Project): TaskProvider<AssembleSite> {
        project.tasks.withType(AssembleSite::class.java).configureEach {
            it.page.set(project.layout.projectDirectory.dir("src/site"))
        }
        return project.tasks.register("assembleSite", AssembleSite::class.java) { task ->
            task.description = "Assembles the site for tests."
            task.app.fileProvider(builtApp(project))
            task.site.set(project.layout.buildDirectory.dir("assembled-site"))
        }
    }

    /** `assembleRelease`: the same, small and fast. `dist`: the folder to upload, with compressed files. */
    private fun addRelease(project: Project): TaskProvider<AssembleSite> {
        val link = project.tasks.named("compileProductionExecutableKotlinWasmJs", KotlinJsIrLink::class.java)
        val optimize = project.tasks.register("optimizeApp", OptimizeWasm::class.java) { task ->
            task.description = "Makes the app's wasm small and fast."
            task.linked.set(link.flatMap { it.destinationDirectory.file("robotran.wasm") })
            task.arguments.set(WasmOptimisation.arguments(project, WasmOptimisation.RELEASE_PASSES))
            task.optimized.set(project.layout.buildDirectory.file("optimized-app/robotran.wasm"))
        }
        val app = project.tasks.register("releaseApp", ReplaceWasm::class.java) { task ->
            task.description = "Puts the small and fast wasm into what webpack has made."
            task.app.fileProvider(builtApp(project))
            task.wasm.set(optimize.flatMap { it.optimized })
            task.replaced.set(project.layout.buildDirectory.dir("release-app"))
        }
        val assemble = project.tasks.register("assembleRelease", AssembleSite::class.java) { task ->
            task.description = "Assembles the site for pupils, without compressed files."
            task.app.set(app.flatMap { it.replaced })
            task.site.set(project.layout.buildDirectory.dir("release-site"))
        }
        project.tasks.register("dist", CompressSite::class.java) { task ->
            task.group = "distribution"
            task.description = "Makes build/site, the folder to put on a web server."
            task.page.set(assemble.flatMap { it.site })
            task.site.set(project.layout.buildDirectory.dir("site"))
        }
        return assemble
    }

    /** The output of webpack and Kotlin's plugin. */
    private fun builtApp(project: Project): Provider<File> =
        project.tasks.named("wasmJsBrowserDistribution").map { it.outputs.files.singleFile }

    private fun addBrowserTest(project: Project, site: TaskProvider<AssembleSite>): TaskProvider<BrowserTest> {
        project.tasks.withType(BrowserTest::class.java).configureEach { task ->
            task.group = "verification"
            task.page.set(site.flatMap { it.site })
            task.helpers.from(project.fileTree("src/browserTest") { it.exclude("**/*.test.mjs") })
            // Solutions need their worlds, which the page does not open.
            task.examples.from(project.rootProject.fileTree("examples") { it.exclude("solutions/**") })
            task.expectedProjectRuns.set(project.rootProject.file("shared/projects/src/commonTest/resources/runs"))
            task.expectedRuns.set(project.rootProject.file("shared/simulation/src/commonTest/resources/runs"))
            task.expectedJavaRuns.set(project.rootProject.file("shared/programs/src/commonTest/resources/runs"))
            task.results.set(project.layout.buildDirectory.dir("test-results/${task.name}"))
        }
        return project.tasks.register("browserTest", BrowserTest::class.java) { task ->
            task.description = "Drives the built page in headless Chromium and takes pictures of it."
            task.tests.from(project.fileTree("src/browserTest") { it.include("*.test.mjs") })
            task.pictures.set(project.layout.buildDirectory.dir("pictures"))
        }
    }

    /** `engineTest`: a short test of the page in each browser engine that pupils use. */
    private fun addEngineTest(project: Project): TaskProvider<BrowserTest> =
        project.tasks.register("engineTest", BrowserTest::class.java) { task ->
            task.description =
                "Visits the built page in Chromium, Firefox and WebKit: it starts, runs programs, and needs no " +
                "network then."
            task.engines.from(FindPrograms.found(project, FindPrograms.ENGINES))
            task.tests.from(project.fileTree("src/browserTest/engines") { it.include("*.test.mjs") })
            task.pictures.set(project.layout.buildDirectory.dir("engine-pictures"))
        }

    /** `releaseTest`: the same for the site that pupils get, which `check` does not make, in Chromium only. */
    private fun addReleaseTest(project: Project, site: TaskProvider<AssembleSite>) {
        project.tasks.register("releaseTest", BrowserTest::class.java) { task ->
            task.description = "Visits the page that pupils get: it starts, runs programs, and needs no network then."
            task.page.set(site.flatMap { it.site })
            task.tests.from(project.fileTree("src/browserTest/engines") { it.include("*.test.mjs") })
            task.onlyEngine.set("Chromium")
            task.pictures.set(project.layout.buildDirectory.dir("release-pictures"))
        }
    }

    /** `measurePage`: measures the start-up time and the frame rate of the page; run by hand. */
    private fun addMeasuring(project: Project) {
        project.tasks.register("measurePage", MeasurePage::class.java) { task ->
            task.group = "verification"
            task.description =
                "Measures the built page in headless Chromium: loading over a slow network, frames, memory."
            task.page.set(project.tasks.named("dist", CompressSite::class.java).flatMap { it.site })
            task.script.set(project.file("src/browserTest/measure.mjs"))
            task.names.set(project.providers.gradleProperty("measure").map { it.split(",") }.orElse(emptyList()))
        }
    }
}
