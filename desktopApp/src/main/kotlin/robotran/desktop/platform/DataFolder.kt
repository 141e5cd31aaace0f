package robotran.desktop.platform

import java.nio.file.Path

/**
 * The folder for app data: `ROBOTRAN_DATA` if set, otherwise the platform's default (XDG Base Directory, `%APPDATA%`,
 * `~/Library/Application Support`).
 */
internal fun dataFolder(
    environment: Map<String, String> = System.getenv(),
    system: String = System.getProperty("os.name").orEmpty(),
    home: Path = Path.of(System.getProperty("user.home")),
): Path {
    fun named(variable: String): Path? =
        environment[variable]?.takeIf { it.isNotBlank() }?.let(Path::of)?.takeIf { it.isAbsolute }
    return named("ROBOTRAN_DATA") ?: when {
        system.startsWith("Windows") -> (named("APPDATA") ?: home.resolve("AppData/Roaming")).resolve("Robotran")
        system.startsWith("Mac") -> home.resolve("Library/Application Support/Robotran")
        else -> (named("XDG_DATA_HOME") ?: home.resolve(".local/share")).resolve("robotran")
    }
}
