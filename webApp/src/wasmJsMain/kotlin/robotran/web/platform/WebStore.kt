@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import kotlinx.coroutines.await
import robotran.documents.ProjectLock
import robotran.documents.StoreResult
import robotran.workshop.platform.KeyValueStore
import kotlin.js.Promise

/**
 * Texts in the browser's IndexedDB, with atomic writes. Claims are Web Locks, which the browser releases when the page
 * ends for any reason. Without Web Locks each page gets every claim.
 *
 * A database that says nothing for some seconds counts as none until it answers: nothing else waits for it.
 */
internal class WebStore : KeyValueStore {
    private val texts = openTexts()

    override val isAnswering: Boolean get() = !texts.isSilent()

    override suspend fun names(): List<String> = texts.names().await<JsString>().toString().split('\n').filter {
        it.isNotEmpty()
    }

    override suspend fun read(name: String): String? = texts.read(name).await<JsString?>()?.toString()

    override suspend fun write(name: String, text: String): StoreResult =
        resultOf(texts.write(name, text).await<JsString>().toString())

    override suspend fun remove(name: String): StoreResult = resultOf(texts.remove(name).await<JsString>().toString())

    override suspend fun claim(name: String): ProjectLock? =
        texts.claim(name).await<JsAny?>()?.let { release -> ProjectLock { letGo(release) } }

    private fun resultOf(word: String): StoreResult = when (word) {
        DONE -> StoreResult.Done
        FULL -> StoreResult.Full
        SILENT -> StoreResult.NoAnswer
        else -> StoreResult.Failed(word)
    }

    private companion object {
        const val DONE = "done"
        const val FULL = "full"
        const val SILENT = "silent"
    }
}

private external interface BrowserTexts : JsAny {
    fun isSilent(): Boolean

    fun names(): Promise<JsString>

    fun read(name: String): Promise<JsString?>

    fun write(name: String, text: String): Promise<JsString>

    fun remove(name: String): Promise<JsString>

    fun claim(name: String): Promise<JsAny?>
}

private fun letGo(release: JsAny): Unit = js("release()")

private fun openTexts(): BrowserTexts = js(
    """(() => {
        const opened = new Promise((resolve, reject) => {
            const request = indexedDB.open('robotran', 1);
            request.onupgradeneeded = () => request.result.createObjectStore('texts');
            request.onsuccess = () => resolve(request.result);
            request.onerror = () => reject(request.error);
        });
        // Milliseconds. A database that another tab upgrades, or a broken profile, may never answer.
        const PATIENCE = 5000;
        let silent = false;
        const answered = (promise) => new Promise((resolve, reject) => {
            const timer = setTimeout(() => { silent = true; reject(new Error('silent')); }, PATIENCE);
            const end = (settle) => (value) => { clearTimeout(timer); silent = false; settle(value); };
            promise.then(end(resolve), end(reject));
        });
        let database = null;
        opened.then((found) => { database = found; }, () => undefined);
        // At once where it can be: a page that goes does nothing later.
        const act = async (mode, work) => {
            // The first that waits in vain does so for all. It goes on as soon as an answer comes.
            if (silent) throw new Error('silent');
            if (database === null) database = await answered(opened);
            return answered(new Promise((resolve, reject) => {
                const transaction = database.transaction('texts', mode, { durability: 'strict' });
                const request = work(transaction.objectStore('texts'));
                // So that it is done even if the page goes before it hears of it.
                if (mode === 'readwrite' && transaction.commit) transaction.commit();
                transaction.oncomplete = () => resolve(request.result);
                transaction.onabort = () => reject(transaction.error || request.error);
            }));
        };
        // Whoever writes wants it to stay: the browser is asked once not to clear it away when the disk runs full.
        // Firefox would ask the pupil.
        let asked = /Firefox/.test(navigator.userAgent) || !navigator.storage || !navigator.storage.persist;
        const stay = () => {
            if (asked) return;
            asked = true;
            navigator.storage.persist().catch(() => undefined);
        };
        const word = (error) => error && error.name === 'QuotaExceededError' ? 'full' : String(error &&
        error.message || error);
        const told = (promise) => promise.then(() => 'done', word);
        const claim = (name) => new Promise((resolve) => {
            if (!navigator.locks) {
                resolve(() => undefined);
                return;
            }
            const hold = (lock) => lock ? new Promise((release) => resolve(() => release())) : resolve(null);
            navigator.locks.request('robotran-' + name, { ifAvailable: true }, hold).catch(() => resolve(() => undefined));
        });
        return {
            isSilent: () => silent,
            names: () => act('readonly', (texts) => texts.getAllKeys()).then((keys) => keys.join('\n'), () => ''),
            read: (name) => act('readonly', (texts) => texts.get(name)).then((text) => text === undefined ? null : text, () => null),
            write: (name, text) => {
                stay();
                return told(act('readwrite', (texts) => texts.put(text, name)));
            },
            remove: (name) => told(act('readwrite', (texts) => texts.delete(name))),
            claim,
        };
    })()""",
)
