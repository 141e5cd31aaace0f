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

/**
 * Parses the files that scripts pass as lines: a name after its folders, a tab, and the content in Base64; for an
 * [OpenedFile.isUnread] file another tab instead.
 */
internal fun filesIn(lines: String): List<OpenedFile> = lines.split('\n').filter { '\t' in it }.map { line ->
    val path = line.substringBefore('\t')
    val name = path.removeSuffix("/").substringAfterLast('/')
    val content = line.substringAfter('\t')
    val isUnread = content == "\t"
    OpenedFile(name, if (isUnread) ByteArray(0) else Base64.decode(content), path = path, isUnread = isUnread)
}

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

/**
 * Installs the scripts that encode files as lines, see [filesIn], and that find the files in what was dropped. A folder
 * gives the files in it that Robotran may read; one without any gives itself, so that its pupil is not forgotten.
 */
internal fun prepareReadingOfFiles(): Unit = js(
    """{
        const most = 16000000;
        const mostFiles = 2000;
        const mostFolders = 8;
        const readable = /\.(robotran|json|robo|java|nqc|nqh|lasm|rcx|zip|txt|url|webloc|html|htm|md|eml)$/i;
        const plain = (name) => name.replace(/[\t\n\/]/g, ' ');
        globalThis.robotranFiles = async (files) => {
            const lines = [];
            for (const file of Array.from(files)) {
                if (file.robotranUnread) {
                    lines.push(file.robotranPath + '\t\t');
                    continue;
                }
                if (file.size > most) continue;
                const bytes = new Uint8Array(await file.arrayBuffer());
                const letters = [];
                for (let place = 0; place < bytes.length; place += 8192) {
                    letters.push(String.fromCharCode(...bytes.subarray(place, place + 8192)));
                }
                const path = file.robotranPath || plain(file.name);
                lines.push(path + '\t' + btoa(letters.join('')));
            }
            return lines.join('\n');
        };
        const entriesIn = (folder) => new Promise((resolve) => {
            const reader = folder.createReader();
            const all = [];
            const more = () => reader.readEntries((some) => {
                all.push(...some);
                if (some.length === 0 || all.length > mostFiles) resolve(all); else more();
            }, () => resolve(all));
            more();
        });
        const fileIn = (entry) => new Promise((resolve) => entry.file(resolve, () => resolve(null)));
        const collect = async (entry, folders, found) => {
            if (found.length >= mostFiles || entry.name.startsWith('.')) return;
            if (entry.isDirectory) {
                if (folders.length >= mostFolders) return;
                const inside = [...folders, plain(entry.name)];
                const before = found.length;
                const entries = await entriesIn(entry);
                for (const next of entries) await collect(next, inside, found);
                if (found.length > before) return;
                const other = entries.find((next) => next.isFile && !next.name.startsWith('.'));
                const path = [...inside, other ? plain(other.name) : ''].join('/');
                found.push({ robotranPath: path, robotranUnread: true });
            } else if (folders.length === 0 || readable.test(entry.name)) {
                const file = await fileIn(entry);
                if (!file) return;
                if (folders.length > 0) {
                    file.robotranPath = [...folders, plain(file.name)].join('/');
                }
                found.push(file);
            }
        };
        globalThis.robotranDropped = async (dropped) => {
            // What was dropped is there only while the event lasts.
            const entries = Array.from(dropped.items || [])
                .map((item) => item.kind === 'file' && item.webkitGetAsEntry ? item.webkitGetAsEntry() : null)
                .filter((entry) => entry);
            const files = Array.from(dropped.files);
            if (!entries.some((entry) => entry.isDirectory)) return globalThis.robotranFiles(files);
            const found = [];
            for (const entry of entries) await collect(entry, [], found);
            return globalThis.robotranFiles(found);
        };
    }""",
)
