package robotran.sdk;

import java.util.Arrays;
import java.util.Set;
import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.RecordComponentVisitor;
import org.objectweb.asm.Type;

/** Reduces a class to what a compiler needs: its public and protected members, with bodies that only throw. */
final class ClassStubber {
    private static final int ASM = Opcodes.ASM9;
    private static final int VISIBLE = Opcodes.ACC_PUBLIC | Opcodes.ACC_PROTECTED;
    private static final int NOT_IN_A_STUB = Opcodes.ACC_NATIVE | Opcodes.ACC_SYNCHRONIZED;

    private final Set<String> known;

    /** @param known internal names of all available classes; members that refer to others are removed. */
    ClassStubber(Set<String> known) {
        this.known = known;
    }

    byte[] stub(byte[] original) {
        ClassWriter writer = new ClassWriter(0);
        int skipped = ClassReader.SKIP_CODE | ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES;
        new ClassReader(original).accept(new Outline(writer), skipped);
        return writer.toByteArray();
    }

    private boolean isKnown(Type type) {
        switch (type.getSort()) {
            case Type.ARRAY:
                return isKnown(type.getElementType());
            case Type.OBJECT:
                return known.contains(type.getInternalName());
            case Type.METHOD:
                return isKnown(type.getReturnType()) && Arrays.stream(type.getArgumentTypes()).allMatch(this::isKnown);
            default:
                return true;
        }
    }

    private final class Outline extends ClassVisitor {
        private String parent;

        Outline(ClassVisitor next) {
            super(ASM, next);
        }

        @Override
        public void visit(
                int version, int access, String name, String signature, String originalParent, String[] interfaces) {
            String[] knownInterfaces = Arrays.stream(interfaces).filter(known::contains).toArray(String[]::new);
            boolean hasKnownParent = originalParent == null || known.contains(originalParent);
            // A signature repeats parent and interfaces, so it must be removed together with them.
            boolean isWhole = hasKnownParent && knownInterfaces.length == interfaces.length;
            parent = hasKnownParent ? originalParent : "java/lang/Object";
            super.visit(version, access, name, isWhole ? signature : null, parent, knownInterfaces);
        }

        @Override
        public void visitInnerClass(String name, String outer, String simpleName, int access) {
            if (outer != null && known.contains(name)) {
                super.visitInnerClass(name, outer, simpleName, access);
            }
        }

        @Override
        public FieldVisitor visitField(int access, String name, String descriptor, String signature, Object value) {
            boolean isKept = (access & VISIBLE) != 0 && isKnown(Type.getType(descriptor));
            return isKept ? super.visitField(access, name, descriptor, signature, value) : null;
        }

        @Override
        public MethodVisitor visitMethod(
                int access, String name, String descriptor, String signature, String[] exceptions) {
            Type type = Type.getMethodType(descriptor);
            if ((access & VISIBLE) == 0 || !isKnown(type)) {
                return null;
            }
            int stubAccess = access & ~NOT_IN_A_STUB;
            MethodVisitor method = super.visitMethod(stubAccess, name, descriptor, signature, exceptions);
            if ((access & Opcodes.ACC_ABSTRACT) != 0) {
                return method;
            }
            return new ThrowingBody(method, type, name.equals("<init>") ? parent : null);
        }

        // Removes references to private members, which the stub does not have:

        @Override
        public void visitNestHost(String host) {}

        @Override
        public void visitNestMember(String member) {}

        @Override
        public void visitPermittedSubclass(String subclass) {}

        @Override
        public void visitOuterClass(String owner, String name, String descriptor) {}

        @Override
        public RecordComponentVisitor visitRecordComponent(String name, String descriptor, String signature) {
            return null;
        }
    }

    private final class ThrowingBody extends MethodVisitor {
        private final Type type;
        private final String parentToConstruct;

        /** @param parentToConstruct the parent class if this is a constructor, else null. */
        ThrowingBody(MethodVisitor next, Type type, String parentToConstruct) {
            super(ASM, next);
            this.type = type;
            this.parentToConstruct = parentToConstruct;
        }

        @Override
        public AnnotationVisitor visitAnnotation(String descriptor, boolean visible) {
            return isKnown(Type.getType(descriptor)) ? super.visitAnnotation(descriptor, visible) : null;
        }

        @Override
        public void visitEnd() {
            String exception = "java/lang/RuntimeException";
            visitCode();
            if (parentToConstruct != null) {
                // The jar that unit tests see has the throwing cut off, and a constructor is only legal with this call.
                visitVarInsn(Opcodes.ALOAD, 0);
                visitMethodInsn(Opcodes.INVOKESPECIAL, parentToConstruct, "<init>", "()V", false);
            }
            visitTypeInsn(Opcodes.NEW, exception);
            visitInsn(Opcodes.DUP);
            visitLdcInsn("Stub!");
            visitMethodInsn(Opcodes.INVOKESPECIAL, exception, "<init>", "(Ljava/lang/String;)V", false);
            visitInsn(Opcodes.ATHROW);
            int argumentSlots = type.getArgumentsAndReturnSizes() >> 2;
            visitMaxs(3, argumentSlots);
            super.visitEnd();
        }
    }
}
