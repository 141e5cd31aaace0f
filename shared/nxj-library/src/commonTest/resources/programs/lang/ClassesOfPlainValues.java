import java.io.Closeable;

public class ClassesOfPlainValues {
    enum Side { LEFT, RIGHT }

    static class Door implements Runnable, Closeable {
        public void run() {
        }

        public void close() {
        }
    }

    public static void main(String[] arguments) {
        System.out.println(int.class == Integer.TYPE); // expect true
        System.out.println(int.class == (Class<?>) Integer.class); // expect false
        System.out.println(int.class.isPrimitive() + " " + void.class.isPrimitive() + " " + Object.class.isPrimitive()); // expect true true false
        System.out.println(int[].class.getComponentType() == int.class); // expect true
        System.out.println(boolean[][].class.getComponentType() == boolean[].class); // expect true
        System.out.println(String[].class.getComponentType() == String.class); // expect true
        System.out.println(String.class.getComponentType()); // expect null
        System.out.println((Class<?>) double.class == float.class); // expect false
        System.out.println(char[].class.getComponentType() == Character.TYPE); // expect true
        Class<?>[] all = Door.class.getInterfaces();
        System.out.println(all.length + " " + (all[0] == Runnable.class) + " " + (all[1] == Closeable.class)); // expect 2 true true
        System.out.println(Side.class.isEnum() + " " + Door.class.isEnum() + " " + Door.class.isAnnotation()); // expect true false false
        Object door = new Door();
        System.out.println(Door.class.cast(door) == door); // expect true
        System.out.println(Door.class.asSubclass(Runnable.class) == (Class<?>) Door.class); // expect true
        try {
            Side.class.cast(door);
        } catch (ClassCastException wrong) {
            System.out.println("no side"); // expect no side
        }
        try {
            Door.class.asSubclass(Side.class);
        } catch (ClassCastException wrong) {
            System.out.println("no subclass"); // expect no subclass
        }
    }
}
