package robotran.build.mpy

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/** Puts MicroPython's cross compiler, a WebAssembly module, among the resources of a multiplatform module on the JVM. */
class MpyCrossPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val fetch = project.tasks.register("fetchMpyCross", FetchMpyCross::class.java) { task ->
            val folder = project.rootProject.layout.projectDirectory.dir("gradle/bootstrap/mpy-cross")
            task.packageFile.set(folder.file("package.json"))
            task.lock.set(folder.file("package-lock.json"))
            task.sha256.set(SHA_256)
            task.folderInside.set("robotran/mpycompiler")
            task.outputFolder.set(project.layout.buildDirectory.dir("mpy-cross"))
        }
        project.extensions.getByType(KotlinMultiplatformExtension::class.java)
            .sourceSets.getByName("jvmMain").resources.srcDir(fetch)
    }

    private companion object {
        /** Of `mpy-cross-v6.wasm` in version 2.0.0 of the package. */
        const val SHA_256 = "9bb7a645cf6f012555d74dbda367db76b28849b6f6b992d4f6ae9986412fb489"
    }
}
