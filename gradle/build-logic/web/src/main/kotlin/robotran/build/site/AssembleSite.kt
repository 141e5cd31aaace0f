package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import java.io.File

/**
 * Assembles the folder for a web server, see docs/hosting.md: `index.html`, `manifest.webmanifest`, `embedding.json` and
 * `service-worker.js`, and all other files in `files` under names that contain a content hash. The output is
 * reproducible.
 */
@CacheableTask
abstract class AssembleSite : DefaultTask() {
    /** The output of webpack and Kotlin's plugin. */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val app: DirectoryProperty

    /**
     * The page around the app: its HTML, style, scripts and service worker with `{{placeholders}}`, its manifest, and
     * the folder `icons`.
     */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val page: DirectoryProperty

    @get:OutputDirectory
    abstract val site: DirectoryProperty

    @TaskAction
    fun assemble() {
        val output = site.get().asFile
        output.deleteRecursively()
        val builtApp = BuiltApp(app.get().asFile)
        val icons = page.get().asFile.resolve("icons").listFiles().orEmpty().sorted().map(SiteFile::of)
        val worker = SiteFile.of(shellFile("worker.js"))
        val files = builtApp.code + builtApp.resources.values + icons + worker
        for (file in files) file.content.copyTo(output.resolve(file.address), overwrite = true)
        val notices = builtApp.notices.map { it to "${SiteFile.FOLDER}/${it.name}" }
        for ((notice, address) in notices) notice.copyTo(output.resolve(address))

        val addresses = icons.associate { it.content.name to it.address }
        val manifest = filled("manifest.webmanifest", addresses)
        val version = versionOf(files, manifest)
        val html = htmlOf(builtApp, version, worker, addresses)
        output.resolve("index.html").writeText(html)
        output.resolve("manifest.webmanifest").writeText(manifest)
        shellFile(EMBEDDING).copyTo(output.resolve(EMBEDDING))
        val kept =
            files.sortedBy {
                it.address
            }.distinctBy { it.address }.map { listOf(it.address, integrityOf(it.content.readBytes())) } +
                notices.map { (notice, address) -> listOf(address, integrityOf(notice.readBytes())) } +
                listOf(
                    listOf("manifest.webmanifest", integrityOf(manifest.toByteArray())),
                    listOf("", integrityOf(html.toByteArray())),
                )
        output.resolve("service-worker.js").writeText(
            filled(
                "service-worker.js",
                mapOf(
                    "version" to version,
                    "files" to json(kept),
                ),
            ),
        )
    }

    private fun htmlOf(app: BuiltApp, version: String, worker: SiteFile, addresses: Map<String, String>): String {
        val script = SCRIPTS.joinToString("") { filled(it, emptyMap()) }
        val style = filled("page.css", emptyMap())
        val site =
            mapOf(
                "version" to version,
                "script" to app.script.address,
                "first" to app.neededFirst.map { listOf(it.address, it.content.length()) },
                "streamed" to app.streamed.map { it.address },
                "worker" to worker.address,
                "chunks" to app.chunksForWorkers.map { it.address },
                "rests" to app.rests.map { pieces -> pieces.map { listOf(it.address, it.content.length()) } },
                "resources" to app.resources.mapValues { it.value.address },
            )
        val own =
            mapOf(
                "policy" to policyFor(script, style),
                "script" to script,
                "style" to style,
                "site" to json(site),
                "start" to script,
            )
        return filled("index.html", addresses + own)
    }

    /** Includes the page's shell, so that pages with an older shell update. */
    private fun versionOf(files: List<SiteFile>, manifest: String): String {
        val shell = (listOf("index.html", "page.css", "service-worker.js") + SCRIPTS).map { shellFile(it).readText() }
        return hexOf(
            sha256(
                (
                    files.map { it.name }.sorted() + manifest + shell
                ).joinToString("\n").toByteArray(),
            ),
        ).take(VERSION_DIGITS)
    }

    private fun filled(name: String, values: Map<String, String>): String =
        PLACE.replace(shellFile(name).readText()) { place ->
            values[place.groupValues[1]]
                ?: throw GradleException("Nothing is known to put in place of ${place.value} in $name.")
        }

    private fun shellFile(name: String): File = page.get().asFile.resolve(name)

    private companion object {
        val PLACE = Regex("""\{\{([\w.-]+)}}""")
        const val VERSION_DIGITS = 16

        /** What together is the script in the page. */
        val SCRIPTS = listOf("parts.js", "start.js")

        /** Whoever hosts the site may edit it, so it is not a part of the version. */
        const val EMBEDDING = "embedding.json"
    }
}
