package embedded;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Enumeration;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.gradle.internal.impldep.org.objectweb.asm.ClassReader;
import org.gradle.internal.impldep.org.objectweb.asm.ClassVisitor;
import org.gradle.internal.impldep.org.objectweb.asm.ClassWriter;
import org.gradle.internal.impldep.org.objectweb.asm.MethodVisitor;
import org.gradle.internal.impldep.org.objectweb.asm.Opcodes;

/**
 * The shaded jar relocated classes, but not the method descriptors in string constants. Compilers write such constants
 * into {@code $deserializeLambda$}, so a serialized lambda of these classes cannot be read again, which the
 * configuration cache does. This class writes the same classes with relocated descriptors.
 */
public final class LambdaDescriptorRelocator {
    private static final String SHADED = "org/gradle/internal/impldep/";
    private static final Pattern CLASS_IN_DESCRIPTOR = Pattern.compile("L([^;<]+);");

    private LambdaDescriptorRelocator() {}

    public static void main(String[] args) throws IOException {
        relocate(new File(args[0]), Path.of(args[1]));
    }

    static void relocate(File shadedJar, Path target) throws IOException {
        try (JarFile jar = new JarFile(shadedJar)) {
            for (Enumeration<JarEntry> entries = jar.entries(); entries.hasMoreElements(); ) {
                JarEntry entry = entries.nextElement();
                String name = entry.getName();
                if (name.startsWith("org/gradle/") && !name.startsWith(SHADED) && name.endsWith(".class")) {
                    try (InputStream in = jar.getInputStream(entry)) {
                        Relocation relocation = new Relocation(jar);
                        new ClassReader(in.readAllBytes()).accept(relocation, 0);
                        if (relocation.changed) {
                            Path file = target.resolve(name);
                            Files.createDirectories(file.getParent());
                            Files.write(file, relocation.writer.toByteArray());
                        }
                    }
                }
            }
        }
    }

    private static final class Relocation extends ClassVisitor {
        final ClassWriter writer;
        private final JarFile jar;
        boolean changed;

        Relocation(JarFile jar) {
            this(jar, new ClassWriter(0));
        }

        private Relocation(JarFile jar, ClassWriter writer) {
            super(Opcodes.ASM9, writer);
            this.jar = jar;
            this.writer = writer;
        }

        @Override
        public MethodVisitor visitMethod(
            int access, String name, String descriptor, String signature, String[] exceptions
        ) {
            MethodVisitor method = super.visitMethod(access, name, descriptor, signature, exceptions);
            if (!name.equals("$deserializeLambda$")) {
                return method;
            }
            return new MethodVisitor(Opcodes.ASM9, method) {
                @Override
                public void visitLdcInsn(Object value) {
                    super.visitLdcInsn(value instanceof String ? relocated((String) value) : value);
                }
            };
        }

        private String relocated(String descriptor) {
            Matcher matcher = CLASS_IN_DESCRIPTOR.matcher(descriptor);
            return matcher.replaceAll(match -> {
                String type = match.group(1);
                if (jar.getEntry(type + ".class") == null && jar.getEntry(SHADED + type + ".class") != null) {
                    changed = true;
                    type = SHADED + type;
                }
                return Matcher.quoteReplacement("L" + type + ";");
            });
        }
    }
}
