package robotran.sdk;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** The sources of the class files. Maps are from internal class name ({@code android/app/Activity}) to bytes. */
final class ClassSources {
    private static final String CLASS_SUFFIX = ".class";

    private static final Pattern ANONYMOUS_OR_LOCAL = Pattern.compile(".*\\$\\d.*");

    /** The packages of Android's public API. */
    private static final List<String> FRAMEWORK =
            List.of("android/", "dalvik/", "javax/microedition/", "org/apache/http/", "org/json/", "org/xmlpull/");

    /** The part of each JDK module that Android has, too. */
    private static final Map<String, List<String>> JDK =
            Map.of(
                    "java.base", List.of("java/", "javax/"),
                    "java.desktop", List.of("java/awt/font/", "java/beans/"),
                    "java.logging", List.of("java/"),
                    "java.prefs", List.of("java/"),
                    "java.sql", List.of("java/", "javax/"),
                    "java.xml", List.of("javax/", "org/"));

    private ClassSources() {}

    /** The classes of Android's own API in the jar of Robolectric's {@code android-all}. */
    static Map<String, byte[]> frameworkClasses(Path androidAll) throws IOException {
        Map<String, byte[]> classes = new TreeMap<>();
        try (ZipFile zip = new ZipFile(androidAll.toFile())) {
            for (ZipEntry entry : Collections.list(zip.entries())) {
                String file = entry.getName();
                if (isWanted(file, FRAMEWORK)) {
                    classes.put(className(file), zip.getInputStream(entry).readAllBytes());
                }
            }
        }
        return classes;
    }

    /** The parts of the framework that aapt2 needs: its resource table and manifest. */
    static Map<String, byte[]> frameworkResourceTable(Path androidAll) throws IOException {
        Map<String, byte[]> files = new TreeMap<>();
        try (ZipFile zip = new ZipFile(androidAll.toFile())) {
            for (String file : List.of("AndroidManifest.xml", "resources.arsc")) {
                files.put(file, zip.getInputStream(zip.getEntry(file)).readAllBytes());
            }
        }
        return files;
    }

    /** The {@code java.*} and {@code javax.*} classes of the current JDK that Android has, too. */
    static Map<String, byte[]> javaClasses() throws IOException {
        Path modules = FileSystems.getFileSystem(URI.create("jrt:/")).getPath("modules");
        Map<String, byte[]> classes = new TreeMap<>();
        for (Map.Entry<String, List<String>> part : JDK.entrySet()) {
            Path module = modules.resolve(part.getKey());
            try (Stream<Path> paths = Files.walk(module)) {
                for (Path path : (Iterable<Path>) paths::iterator) {
                    String file = module.relativize(path).toString();
                    if (isWanted(file, part.getValue())) {
                        classes.put(className(file), Files.readAllBytes(path));
                    }
                }
            } catch (UncheckedIOException failure) {
                throw failure.getCause();
            }
        }
        return classes;
    }

    private static boolean isWanted(String file, List<String> packages) {
        return file.endsWith(CLASS_SUFFIX)
                && startsWithAny(file, packages)
                && !file.endsWith("package-info.class")
                && !ANONYMOUS_OR_LOCAL.matcher(file).matches();
    }

    private static boolean startsWithAny(String file, List<String> prefixes) {
        return prefixes.stream().anyMatch(file::startsWith);
    }

    private static String className(String file) {
        return file.substring(0, file.length() - CLASS_SUFFIX.length());
    }
}
