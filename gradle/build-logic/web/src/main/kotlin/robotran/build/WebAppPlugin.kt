package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.TaskProvider
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import org.jetbrains.kotlin.gradle.targets.js.ir.KotlinJsIrLink
import org.jetbrains.kotlin.gradle.targets.js.webpack.KotlinWebpack
import robotran.build.site.AssembleSite
import robotran.build.site.CompressSite
import robotran.build.wasm.StubFunctions

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
        val sites = SiteTasks(project)
        val site = sites.addSite()
        val browserTest = addBrowserTest(project, site)
        val engineTest = addEngineTest(project)
        // Both need the whole machine.
        engineTest.configure { it.mustRunAfter(browserTest) }
        project.tasks.named("check") { it.dependsOn(browserTest, engineTest) }
        addReleaseTest(project, sites.addRelease())
        sites.addRecording()
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
        project.tasks.named(SiteTasks.LINK, KotlinJsIrLink::class.java) { it.doLast(StubFunctions(SiteTasks.APP)) }
        WasmOptimisation.use(project, WasmOptimisation.TEST_PASSES)
        // A source map is as large as the code, and needs `eval`.
        project.tasks.withType(KotlinWebpack::class.java).configureEach { it.sourceMaps = false }
    }

    private fun addBrowserTest(project: Project, site: TaskProvider<AssembleSite>): TaskProvider<BrowserTest> {
        project.tasks.withType(BrowserTest::class.java).configureEach { task ->
            task.group = "verification"
            task.page.set(site.flatMap { it.site })
            task.helpers.from(project.fileTree("src/browserTest") { it.exclude("**/*.test.mjs") })
            task.examples.from(project.rootProject.fileTree("examples"))
            task.expectedProjectRuns.set(project.rootProject.file("shared/projects/src/commonTest/resources/runs"))
            task.expectedRuns.set(project.rootProject.file("shared/simulation/src/commonTest/resources/runs"))
            task.expectedJavaRuns.set(project.rootProject.file("shared/programs/src/commonTest/resources/runs"))
            task.expectedNxtRuns.set(project.rootProject.file("shared/simulation/src/commonTest/resources/nxt-runs"))
            task.expectedNxjRuns.set(project.rootProject.file("shared/programs/src/commonTest/resources/nxj-runs"))
            task.expectedNqcRuns.set(project.rootProject.file("shared/programs/src/commonTest/resources/nqc-runs"))
            task.expectedGrades.set(project.rootProject.file("shared/assignments/src/commonTest/resources/grades"))
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
