package robotran.sdk;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * Makes the two jars of an SDK platform: {@code android.jar}, which apps are compiled against, and
 * {@code core-for-system-modules.jar}, its {@code java.*} part.
 *
 * <p>Usage: {@code MakeAndroidJar ANDROID_ALL_JAR PLATFORM_FOLDER}
 */
public final class MakeAndroidJar {
    /** 1980-02-01, a date every zip can hold: the same input gives the same jar. */
    private static final long ENTRY_TIME_MILLISECONDS = 318_211_200_000L;

    /** A jar with more entries is a zip64, which the Android build tools do not read. */
    private static final int MOST_ENTRIES = 65_535;

    public static void main(String[] arguments) throws IOException {
        Path androidAll = Path.of(arguments[0]);
        Path platform = Path.of(arguments[1]);

        Map<String, byte[]> framework = ClassSources.frameworkClasses(androidAll);
        Map<String, byte[]> core = ClassSources.javaClasses();
        Map<String, byte[]> all = new TreeMap<>(framework);
        all.putAll(core);

        ClassStubber stubber = new ClassStubber(all.keySet());
        all.replaceAll((name, bytes) -> stubber.stub(bytes));
        Map<String, byte[]> coreStubs = new TreeMap<>(all);
        coreStubs.keySet().retainAll(core.keySet());
        coreStubs.keySet().removeIf(MakeAndroidJar::isGeneratedByJlink);

        writeJar(platform.resolve("core-for-system-modules.jar"), coreStubs, Map.of());
        writeJar(platform.resolve("android.jar"), all, ClassSources.frameworkResourceTable(androidAll));
    }

    /** The Android plugin makes a JDK image of these classes with jlink, which generates some and rejects copies. */
    private static boolean isGeneratedByJlink(String name) {
        return name.startsWith("java/lang/invoke/") && (name.contains("$Species_") || name.endsWith("$Holder"));
    }

    private static void writeJar(Path jar, Map<String, byte[]> classes, Map<String, byte[]> files) throws IOException {
        if (classes.size() + files.size() > MOST_ENTRIES) {
            throw new IOException(jar + " would have more than " + MOST_ENTRIES + " entries");
        }
        try (OutputStream output = new BufferedOutputStream(Files.newOutputStream(jar));
                ZipOutputStream zip = new ZipOutputStream(output)) {
            for (Map.Entry<String, byte[]> type : classes.entrySet()) {
                writeEntry(zip, type.getKey() + ".class", type.getValue());
            }
            for (Map.Entry<String, byte[]> file : files.entrySet()) {
                writeEntry(zip, file.getKey(), file.getValue());
            }
        }
    }

    private static void writeEntry(ZipOutputStream zip, String name, byte[] bytes) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTime(ENTRY_TIME_MILLISECONDS);
        zip.putNextEntry(entry);
        zip.write(bytes);
        zip.closeEntry();
    }
}
