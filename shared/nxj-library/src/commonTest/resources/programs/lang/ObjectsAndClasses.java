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
        System.out.println(first.equals(second) + " " + (first == second) + " " + (first.hashCode() == second.hashCode())); // prints: true false true
        ObjectsAndClasses copy = (ObjectsAndClasses) first.clone();
        copy.value = 4;
        copy.shared[0] = 9;
        System.out.println(first.value + " " + copy.value + " " + first.shared[0]); // prints: 3 4 9
        Object plain = new Object();
        System.out.println(plain.equals(plain) + " " + plain.equals(new Object())); // prints: true false
        System.out.println(plain.hashCode() == plain.hashCode()); // prints: true
        System.out.println(System.identityHashCode(plain) == plain.hashCode()); // prints: true
        System.out.println(plain.getClass() == Object.class); // prints: true
        System.out.println(int[].class == new int[0].getClass()); // prints: true
        System.out.println(Runnable.class.isInterface() + " " + int[].class.isArray() + " " + String.class.isInterface()); // prints: true true false
        System.out.println(Number.class.isAssignableFrom(Integer.class) + " " + Integer.class.isAssignableFrom(Number.class)); // prints: true false
        try {
            new Tight().copy();
        } catch (CloneNotSupportedException wrong) {
            System.out.println("not cloneable"); // prints: not cloneable
        }
    }

    static class Tight {
        Object copy() throws CloneNotSupportedException {
            return clone();
        }
    }
}
