@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import kotlinx.coroutines.await
import robotran.documents.FileKind
import robotran.workshop.platform.FilePicker
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.Saving
import kotlin.io.encoding.Base64
import kotlin.js.Promise

/** Files in a browser: opened with the browser's dialog, saved as downloads. Their paths are unknown. */
internal object WebFilePicker : FilePicker {
    override suspend fun open(kinds: List<FileKind>): List<OpenedFile> {
        // Browsers match only the part after the last dot.
        val endings = kinds.joinToString(",") { ".${it.extension.substringAfterLast('.')}" }
        return filesIn(chooseFiles(endings).await<JsString>().toString())
    }

    override suspend fun save(name: String, kind: FileKind, bytes: ByteArray): Saving {
        download(name, kind.mimeType, Base64.encode(bytes))
        return Saving.Saved(name, location = null)
    }
}

/** Parses the files that scripts pass as lines: a name, a tab, and the content in Base64. */
internal fun filesIn(lines: String): List<OpenedFile> = lines.split('\n').filter {
    '\t' in it
}.map { OpenedFile(it.substringBefore('\t'), Base64.decode(it.substringAfter('\t'))) }

private fun chooseFiles(accept: String): Promise<JsString> = js(
    """new Promise((resolve) => {
        const input = document.createElement('input');
        input.type = 'file';
        input.multiple = true;
        input.accept = accept;
        input.addEventListener('change', () => globalThis.robotranFiles(input.files).then(resolve));
        input.addEventListener('cancel', () => resolve(''));
        input.click();
    })""",
)

private fun download(name: String, type: String, content: String): Unit = js(
    """{
        const bytes = Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0));
        const address = URL.createObjectURL(new Blob([bytes], { type }));
        const link = document.createElement('a');
        link.href = address;
        link.download = name;
        link.click();
        setTimeout(() => URL.revokeObjectURL(address), 60000);
    }""",
)

/** Installs the script that encodes files as lines, see [filesIn]. */
internal fun prepareReadingOfFiles(): Unit = js(
    """{
        const most = 16000000;
        globalThis.robotranFiles = async (files) => {
            const lines = [];
            for (const file of Array.from(files)) {
                if (file.size > most) continue;
                const bytes = new Uint8Array(await file.arrayBuffer());
                const letters = [];
                for (let place = 0; place < bytes.length; place += 8192) {
                    letters.push(String.fromCharCode(...bytes.subarray(place, place + 8192)));
                }
                lines.push(file.name.replace(/[\t\n]/g, ' ') + '\t' + btoa(letters.join('')));
            }
            return lines.join('\n');
        };
    }""",
)
