public class ObjectsAndClasses implements Cloneable {
    private int value = 3;
    private int[] shared = {1};

    @Override
    public boolean equals(Object other) {
        return other instanceof ObjectsAndClasses && ((ObjectsAndClasses) other).value == value;
    }

    @Override
    public int hashCode() {
        return value * 31;
    }

    public static void main(String[] arguments) throws CloneNotSupportedException {
        ObjectsAndClasses first = new ObjectsAndClasses();
        ObjectsAndClasses second = new ObjectsAndClasses();
        System.out.println(first.equals(second) + " " + (first == second) + " " + (first.hashCode() == second.hashCode())); // expect true false true
        ObjectsAndClasses copy = (ObjectsAndClasses) first.clone();
        copy.value = 4;
        copy.shared[0] = 9;
        System.out.println(first.value + " " + copy.value + " " + first.shared[0]); // expect 3 4 9
        Object plain = new Object();
        System.out.println(plain.equals(plain) + " " + plain.equals(new Object())); // expect true false
        System.out.println(plain.hashCode() == plain.hashCode()); // expect true
        System.out.println(System.identityHashCode(plain) == plain.hashCode()); // expect true
        System.out.println(plain.getClass() == Object.class); // expect true
        System.out.println(int[].class == new int[0].getClass()); // expect true
        System.out.println(Runnable.class.isInterface() + " " + int[].class.isArray() + " " + String.class.isInterface()); // expect true true false
        System.out.println(Number.class.isAssignableFrom(Integer.class) + " " + Integer.class.isAssignableFrom(Number.class)); // expect true false
        try {
            new Tight().copy();
        } catch (CloneNotSupportedException wrong) {
            System.out.println("not cloneable"); // expect not cloneable
        }
    }

    static class Tight {
        Object copy() throws CloneNotSupportedException {
            return clone();
        }
    }
}
