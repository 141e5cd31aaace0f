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
        configureTests(project, site)
        addRings(project)
        addEngineTest(project)
        addReleaseTest(project, sites.addRelease())
        sites.addRecording()
        addMeasuring(project)
        Rings.addToQuick(project, "quickTest")
        Rings.addToAll(project, "allBrowserTests", "engineTest", "releaseTest")
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

    private fun configureTests(project: Project, site: TaskProvider<AssembleSite>) {
        project.tasks.withType(BrowserTest::class.java).configureEach { task ->
            task.group = "verification"
            task.page.set(site.flatMap { it.site })
            task.helpers.from(project.fileTree("src/browserTest") { it.exclude("**/*.test.mjs") })
            task.helpers.from("src/first-part/budget.json")
            // Made-up files with MicroPython, which tests open.
            task.helpers.from(project.rootProject.fileTree("shared/microbit-link/src/commonTest/resources/vectors"))
            task.examples.from(project.rootProject.fileTree("examples"))
            task.expectedProjectRuns.set(project.rootProject.file("shared/projects/src/commonTest/resources/runs"))
            task.expectedRuns.set(project.rootProject.file("shared/simulation/src/commonTest/resources/runs"))
            task.expectedJavaRuns.set(project.rootProject.file("shared/programs/src/commonTest/resources/runs"))
            task.expectedNxtRuns.set(project.rootProject.file("shared/simulation/src/commonTest/resources/nxt-runs"))
            task.expectedNxjRuns.set(project.rootProject.file("shared/programs/src/commonTest/resources/nxj-runs"))
            task.expectedNqcRuns.set(project.rootProject.file("shared/programs/src/commonTest/resources/nqc-runs"))
            task.expectedGrades.set(project.rootProject.file("shared/assignments/src/commonTest/resources/grades"))
            task.takesPictures.convention(false)
            task.results.set(project.layout.buildDirectory.dir("test-results/${task.name}"))
        }
    }

    /**
     * The tests in Chromium, by the folder they stand in: `quickTest`; `browserTest`, which `check` runs, with the quick
     * ones; `thoroughTest`, all others, with pictures of the page. `allBrowserTests` runs all of them.
     */
    private fun addRings(project: Project) {
        fun add(name: String, description: String, vararg folders: String): TaskProvider<BrowserTest> =
            project.tasks.register(name, BrowserTest::class.java) { task ->
                task.description = description
                for (folder in folders) task.tests.from(testsIn(project, folder))
                task.pictures.set(project.layout.buildDirectory.dir("$name-pictures"))
            }
        add("quickTest", "Drives the built page in headless Chromium, for a minute.", "quick")
        val browserTest = add("browserTest", "Tests in headless Chromium what only a browser has.", "quick", "check")
        val thoroughTest = add("thoroughTest", "Takes every way through the built page, with pictures of it.", "all")
        thoroughTest.configure {
            it.takesPictures.set(true)
            // Both need the whole machine.
            it.mustRunAfter(browserTest)
        }
        project.tasks.register("allBrowserTests") { task ->
            task.group = "verification"
            task.description = "Runs all tests of the built page in Chromium."
            task.dependsOn(browserTest, thoroughTest)
        }
        project.tasks.named("check") { it.dependsOn(browserTest) }
    }

    private fun testsIn(project: Project, folder: String) =
        project.fileTree("src/browserTest/$folder") { it.include("*.test.mjs") }

    /** `engineTest`: a short test of the page in each browser engine that pupils use. */
    private fun addEngineTest(project: Project) {
        project.tasks.register("engineTest", BrowserTest::class.java) { task ->
            task.description =
                "Visits the built page in Chromium, Firefox and WebKit: it starts, runs programs, and needs no " +
                "network then."
            task.engines.from(FindPrograms.found(project, FindPrograms.ENGINES))
            task.tests.from(testsIn(project, "engines"))
            task.takesPictures.set(true)
            task.pictures.set(project.layout.buildDirectory.dir("engine-pictures"))
            task.mustRunAfter("browserTest", "thoroughTest")
        }
    }

    /** `releaseTest`: the same for the site that pupils get, which `check` does not make, in Chromium only. */
    private fun addReleaseTest(project: Project, site: TaskProvider<AssembleSite>) {
        project.tasks.register("releaseTest", BrowserTest::class.java) { task ->
            task.description = "Visits the page that pupils get: it starts, runs programs, and needs no network then."
            task.page.set(site.flatMap { it.site })
            task.tests.from(testsIn(project, "engines"))
            task.takesPictures.set(true)
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
