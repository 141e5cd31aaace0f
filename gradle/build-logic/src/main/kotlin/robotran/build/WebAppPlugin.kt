package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.TaskProvider
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import org.jetbrains.kotlin.gradle.targets.js.webpack.KotlinWebpack
import robotran.build.site.AssembleSite

/**
 * The web page: one Kotlin/Wasm executable with its page, the folder to put on a web server, and tests that drive it in
 * a real browser.
 */
class WebAppPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.multiplatform")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply("org.jetbrains.compose")
        project.pluginManager.apply("robotran.physics-web")
        project.pluginManager.apply("robotran.ecj-web")
        addTarget(project)
        WebTools.use(project)
        val dist = addSite(project)
        val browserTest = addBrowserTest(project, dist)
        val engineTest = addEngineTest(project)
        // Both want the whole machine.
        engineTest.configure { it.mustRunAfter(browserTest) }
        project.tasks.named("check") { it.dependsOn(browserTest, engineTest) }
        addMeasuring(project, dist)
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
        WasmOptimisation.use(project)
        // A map is as large as what it maps, and would make code of texts.
        project.tasks.withType(KotlinWebpack::class.java).configureEach { it.sourceMaps = false }
    }

    /** `dist`: the folder to put on a web server. */
    private fun addSite(project: Project): TaskProvider<AssembleSite> =
        project.tasks.register("dist", AssembleSite::class.java) { task ->
            task.group = "distribution"
            task.description = "Makes build/site, the folder to put on a web server."
            task.app.fileProvider(project.tasks.named("wasmJsBrowserDistribution").map { it.outputs.files.singleFile })
            task.page.set(project.layout.projectDirectory.dir("src/site"))
            task.site.set(project.layout.buildDirectory.dir("site"))
        }

    private fun addBrowserTest(project: Project, dist: TaskProvider<AssembleSite>): TaskProvider<BrowserTest> {
        project.tasks.withType(BrowserTest::class.java).configureEach { task ->
            task.group = "verification"
            task.page.set(dist.flatMap { it.site })
            task.helpers.from(project.fileTree("src/browserTest") { it.exclude("**/*.test.mjs") })
            // Solutions need the worlds that they are for, which the page does not open.
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

    /** `engineTest`: a short visit to the page in each engine that pupils have. */
    private fun addEngineTest(project: Project): TaskProvider<BrowserTest> =
        project.tasks.register("engineTest", BrowserTest::class.java) { task ->
            task.description =
                "Visits the built page in Chromium, Firefox and WebKit: it starts, runs programs, and needs no " +
                "network then."
            task.engines.from(FindPrograms.found(project, FindPrograms.ENGINES))
            task.tests.from(project.fileTree("src/browserTest/engines") { it.include("*.test.mjs") })
            task.pictures.set(project.layout.buildDirectory.dir("engine-pictures"))
        }

    /** `measurePage`: how long the page takes to be there and how smoothly it runs, by hand. */
    private fun addMeasuring(project: Project, dist: TaskProvider<AssembleSite>) {
        project.tasks.register("measurePage", MeasurePage::class.java) { task ->
            task.group = "verification"
            task.description =
                "Measures the built page in headless Chromium: loading over a slow network, frames, memory."
            task.page.set(dist.flatMap { it.site })
            task.script.set(project.file("src/browserTest/measure.mjs"))
            task.names.set(project.providers.gradleProperty("measure").map { it.split(",") }.orElse(emptyList()))
        }
    }
}
