package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/** The web page: one Kotlin/Wasm executable with its page, and tests that drive the built page in a real browser. */
class WebAppPlugin : Plugin<Project> {
    @OptIn(ExperimentalWasmDsl::class)
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.multiplatform")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply("org.jetbrains.compose")
        project.pluginManager.apply("robotran.physics-web")
        project.pluginManager.apply("robotran.ecj-web")
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
        WebTools.use(project)
        val browserTest =
            project.tasks.register("browserTest", BrowserTest::class.java) { task ->
                task.group = "verification"
                task.description = "Drives the built page in headless Chromium and takes pictures of it."
                task.dependsOn(":${WebTools.SET_UP_TASK}", ":${Chromium.SET_UP_TASK}")
                task.page.fileProvider(
                    project.tasks.named("wasmJsBrowserDevelopmentExecutableDistribution").map { it.outputs.files.singleFile },
                )
                task.tests.from(project.fileTree("src/browserTest"))
                // Solutions need the worlds that they are for, which the page does not open.
                task.examples.from(project.rootProject.fileTree("examples") { it.exclude("solutions/**") })
                task.expectedProjectRuns.set(project.rootProject.file("shared/projects/src/commonTest/resources/runs"))
                task.expectedRuns.set(project.rootProject.file("shared/world/src/commonTest/resources/runs"))
                task.expectedJavaRuns.set(project.rootProject.file("shared/programs/src/commonTest/resources/runs"))
                task.browserFinder.set(project.rootProject.file(Chromium.SCRIPT))
                task.node.set(WebTools.node(project).path)
                task.modules.set(WebTools.directory(project).resolve("node_modules").path)
                task.pictures.set(project.layout.buildDirectory.dir("pictures"))
                task.results.set(project.layout.buildDirectory.dir("test-results/browserTest"))
            }
        project.tasks.named("check") { it.dependsOn(browserTest) }
    }
}
