package robotran.ecj;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.jdt.internal.compiler.ASTVisitor;
import org.eclipse.jdt.internal.compiler.ast.AllocationExpression;
import org.eclipse.jdt.internal.compiler.ast.CompilationUnitDeclaration;
import org.eclipse.jdt.internal.compiler.ast.FieldReference;
import org.eclipse.jdt.internal.compiler.ast.MessageSend;
import org.eclipse.jdt.internal.compiler.ast.QualifiedNameReference;
import org.eclipse.jdt.internal.compiler.ast.TypeDeclaration;
import org.eclipse.jdt.internal.compiler.lookup.BlockScope;
import org.eclipse.jdt.internal.compiler.lookup.FieldBinding;
import org.eclipse.jdt.internal.compiler.lookup.MethodBinding;
import org.eclipse.jdt.internal.compiler.lookup.ReferenceBinding;
import org.eclipse.jdt.internal.compiler.lookup.SourceTypeBinding;
import org.eclipse.jdt.internal.compiler.lookup.TypeBinding;
import org.eclipse.jdt.internal.compiler.lookup.TypeIds;

/** Finds what a class has where a program names a member or a constructor that it has not, or not for all. */
final class MemberNames extends ASTVisitor {
    private final Map<Integer, List<String>> byPlace = new HashMap<>();

    /** Looks through {@code unit}, even if it has errors. */
    void visit(CompilationUnitDeclaration unit) {
        if (unit.types != null) {
            for (TypeDeclaration type : unit.types) {
                type.traverse(this, unit.scope);
            }
        }
    }

    /**
     * The members of the class that is named at {@code place}: fields by their names, methods by their name and the
     * number of their parameters, such as {@code setSpeed(1)}. For a constructor: the parameters of each that the
     * program may use, such as {@code (int, String)}; if there are none, the class's constants that are objects. Null
     * if nothing was found there.
     */
    List<String> at(int place) {
        return byPlace.get(place);
    }

    @Override
    public boolean visit(MessageSend call, BlockScope scope) {
        if (call.binding != null && (!call.binding.isValidBinding() || isHidden(call.binding))) {
            put((int) (call.nameSourcePosition >>> 32), call.actualReceiverType);
        }
        return true;
    }

    @Override
    public boolean visit(FieldReference reference, BlockScope scope) {
        if (reference.binding != null && !reference.binding.isValidBinding()) {
            put((int) (reference.nameSourcePosition >>> 32), reference.actualReceiverType);
        }
        return true;
    }

    @Override
    public boolean visit(QualifiedNameReference name, BlockScope scope) {
        FieldBinding missing = null;
        if (name.binding instanceof FieldBinding && !name.binding.isValidBinding()) {
            missing = (FieldBinding) name.binding;
        }
        if (name.otherBindings != null) {
            for (FieldBinding other : name.otherBindings) {
                if (missing == null && other != null && !other.isValidBinding()) {
                    missing = other;
                }
            }
        }
        if (missing != null) {
            for (long position : name.sourcePositions) {
                put((int) (position >>> 32), missing.declaringClass);
            }
        }
        return true;
    }

    @Override
    public boolean visit(AllocationExpression creation, BlockScope scope) {
        if (creation.binding != null && !creation.binding.isValidBinding()
                && creation.resolvedType instanceof ReferenceBinding) {
            byPlace.put(creation.sourceStart, constructors((ReferenceBinding) creation.resolvedType));
        }
        return true;
    }

    /** Whether a class of the library keeps {@code method} to itself: ECJ took it for a call that fits no other. */
    private static boolean isHidden(MethodBinding method) {
        boolean isOpen = method.isPublic() || method.isProtected();
        return !isOpen && !(method.declaringClass.erasure() instanceof SourceTypeBinding);
    }

    private void put(int place, TypeBinding type) {
        if (type instanceof ReferenceBinding) {
            byPlace.put(place, members((ReferenceBinding) type));
        }
    }

    private static List<String> members(ReferenceBinding type) {
        Set<String> names = new TreeSet<>();
        for (ReferenceBinding next = type; next != null; next = next.superclass()) {
            addMembers(next, names);
            ReferenceBinding[] interfaces = next.superInterfaces();
            for (int i = 0; interfaces != null && i < interfaces.length; i++) {
                addMembers(interfaces[i], names);
            }
        }
        return new ArrayList<>(names);
    }

    private static void addMembers(ReferenceBinding type, Set<String> names) {
        for (MethodBinding method : type.availableMethods()) {
            if (isOpen(type, method.isPublic() || method.isProtected()) && !method.isConstructor()) {
                names.add(new String(method.selector) + "(" + method.parameters.length + ")");
            }
        }
        for (FieldBinding field : type.availableFields()) {
            if (isOpen(type, field.isPublic() || field.isProtected())) {
                names.add(new String(field.name));
            }
        }
    }

    private static List<String> constructors(ReferenceBinding type) {
        List<String> found = new ArrayList<>();
        for (MethodBinding method : type.availableMethods()) {
            if (method.isConstructor() && isOpen(type, method.isPublic())) {
                StringBuilder parameters = new StringBuilder();
                for (TypeBinding parameter : method.parameters) {
                    parameters.append(parameters.length() == 0 ? "" : ", ").append(parameter.shortReadableName());
                }
                found.add("(" + parameters + ")");
            }
        }
        if (found.isEmpty()) {
            for (FieldBinding field : type.availableFields()) {
                boolean isConstant = field.isPublic() && field.isStatic() && field.type instanceof ReferenceBinding;
                if (isConstant && field.type.id != TypeIds.T_JavaLangString) {
                    found.add(new String(field.name));
                }
            }
        }
        Collections.sort(found);
        return found;
    }

    /** The classes of the program name their members to each other, whatever those are. */
    private static boolean isOpen(ReferenceBinding type, boolean isDeclaredOpen) {
        return isDeclaredOpen || type instanceof SourceTypeBinding;
    }
}
