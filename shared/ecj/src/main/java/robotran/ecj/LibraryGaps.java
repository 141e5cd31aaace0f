package robotran.ecj;

import java.util.Set;
import org.eclipse.jdt.internal.compiler.ASTVisitor;
import org.eclipse.jdt.internal.compiler.ast.ASTNode;
import org.eclipse.jdt.internal.compiler.ast.AllocationExpression;
import org.eclipse.jdt.internal.compiler.ast.ArrayQualifiedTypeReference;
import org.eclipse.jdt.internal.compiler.ast.ArrayTypeReference;
import org.eclipse.jdt.internal.compiler.ast.ExplicitConstructorCall;
import org.eclipse.jdt.internal.compiler.ast.FieldReference;
import org.eclipse.jdt.internal.compiler.ast.MessageSend;
import org.eclipse.jdt.internal.compiler.ast.QualifiedAllocationExpression;
import org.eclipse.jdt.internal.compiler.ast.QualifiedNameReference;
import org.eclipse.jdt.internal.compiler.ast.QualifiedTypeReference;
import org.eclipse.jdt.internal.compiler.ast.SingleTypeReference;
import org.eclipse.jdt.internal.compiler.ast.TypeReference;
import org.eclipse.jdt.internal.compiler.lookup.BlockScope;
import org.eclipse.jdt.internal.compiler.lookup.ClassScope;
import org.eclipse.jdt.internal.compiler.lookup.FieldBinding;
import org.eclipse.jdt.internal.compiler.lookup.MethodBinding;
import org.eclipse.jdt.internal.compiler.lookup.TypeBinding;
import org.eclipse.jdt.internal.compiler.lookup.VariableBinding;

/** Finds uses of the classes and members that a brick's class library lacks, see {@link EcjCompiler#addGap}. */
final class LibraryGaps extends ASTVisitor {
    private final Set<String> gaps;
    private final BrickReport report;

    LibraryGaps(Set<String> gaps, BrickReport report) {
        this.gaps = gaps;
        this.report = report;
    }

    @Override
    public boolean visit(AllocationExpression creation, BlockScope scope) {
        checkMethod(creation.binding, creation);
        return true;
    }

    @Override
    public boolean visit(QualifiedAllocationExpression creation, BlockScope scope) {
        checkMethod(creation.binding, creation);
        return true;
    }

    @Override
    public boolean visit(ExplicitConstructorCall call, BlockScope scope) {
        checkMethod(call.binding, call);
        return true;
    }

    @Override
    public boolean visit(MessageSend call, BlockScope scope) {
        if (isKnown(call.binding)) {
            check(keyOf(call.binding), call.nameSourcePosition);
            check(call.binding.declaringClass, call.nameSourcePosition);
        }
        return true;
    }

    @Override
    public boolean visit(FieldReference reference, BlockScope scope) {
        checkField(reference.binding, reference.actualReceiverType, reference.nameSourcePosition);
        return true;
    }

    @Override
    public boolean visit(FieldReference reference, ClassScope scope) {
        checkField(reference.binding, reference.actualReceiverType, reference.nameSourcePosition);
        return true;
    }

    @Override
    public boolean visit(QualifiedNameReference name, BlockScope scope) {
        checkFields(name);
        return true;
    }

    @Override
    public boolean visit(QualifiedNameReference name, ClassScope scope) {
        checkFields(name);
        return true;
    }

    @Override
    public boolean visit(SingleTypeReference type, BlockScope scope) {
        checkType(type);
        return true;
    }

    @Override
    public boolean visit(SingleTypeReference type, ClassScope scope) {
        checkType(type);
        return true;
    }

    @Override
    public boolean visit(QualifiedTypeReference type, BlockScope scope) {
        checkType(type);
        return true;
    }

    @Override
    public boolean visit(QualifiedTypeReference type, ClassScope scope) {
        checkType(type);
        return true;
    }

    @Override
    public boolean visit(ArrayTypeReference type, BlockScope scope) {
        checkType(type);
        return true;
    }

    @Override
    public boolean visit(ArrayTypeReference type, ClassScope scope) {
        checkType(type);
        return true;
    }

    @Override
    public boolean visit(ArrayQualifiedTypeReference type, BlockScope scope) {
        checkType(type);
        return true;
    }

    @Override
    public boolean visit(ArrayQualifiedTypeReference type, ClassScope scope) {
        checkType(type);
        return true;
    }

    private void checkMethod(MethodBinding method, ASTNode use) {
        if (isKnown(method)) {
            check(keyOf(method), use.sourceStart, use.sourceEnd);
        }
    }

    private void checkType(TypeReference type) {
        if (type.resolvedType != null) {
            check(type.resolvedType.leafComponentType(), place(type.sourceStart, type.sourceEnd));
        }
    }

    /** Checks each field of a name such as {@code Sensor.S1.LIMIT}, which may begin with a type or a variable. */
    private void checkFields(QualifiedNameReference name) {
        int token = name.indexOfFirstFieldBinding - 1;
        TypeBinding owner = name.actualReceiverType;
        if (name.binding instanceof FieldBinding && token >= 0) {
            checkField((FieldBinding) name.binding, owner, name.sourcePositions[token]);
        }
        if (name.binding instanceof VariableBinding) {
            owner = ((VariableBinding) name.binding).type;
        }
        if (name.otherBindings == null) {
            return;
        }
        for (FieldBinding field : name.otherBindings) {
            token++;
            if (field != null && token < name.sourcePositions.length) {
                checkField(field, owner, name.sourcePositions[token]);
                owner = field.type;
            }
        }
    }

    /** Checks a field for the class that declares it and the class through which the program names it. */
    private void checkField(FieldBinding field, TypeBinding owner, long place) {
        if (field == null || !field.isValidBinding() || field.declaringClass == null) {
            return; // The length of an array has no class.
        }
        String member = "." + new String(field.name) + ":" + new String(field.type.signature());
        check(field.declaringClass, place);
        check(nameOf(field.declaringClass) + member, place);
        if (owner != null && owner != field.declaringClass) {
            check(nameOf(owner) + member, place);
        }
    }

    private void check(TypeBinding type, long place) {
        check(nameOf(type), place);
    }

    private void check(String key, long place) {
        check(key, (int) (place >>> 32), (int) place);
    }

    private void check(String key, int start, int end) {
        if (gaps.contains(key)) {
            report.refuse(BrickProblem.LIBRARY_GAP, start, end + 1, key);
        }
    }

    private static long place(int start, int end) {
        return (long) start << 32 | end;
    }

    private static boolean isKnown(MethodBinding method) {
        return method != null && method.isValidBinding() && method.declaringClass != null;
    }

    private static String keyOf(MethodBinding method) {
        String name = method.isConstructor() ? "<init>" : new String(method.selector);
        return nameOf(method.declaringClass) + "." + name + new String(method.signature());
    }

    private static String nameOf(TypeBinding type) {
        char[] name = type.constantPoolName();
        return name == null ? "" : new String(name);
    }
}
