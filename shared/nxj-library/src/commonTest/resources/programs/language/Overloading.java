public class Overloading {
    static int kind(int value) {
        return 1;
    }

    static int kind(float value) {
        return 2;
    }

    static int kind(char value) {
        return 3;
    }

    static int kind(Object value) {
        return 4;
    }

    static int kind(String value) {
        return 5;
    }

    static int kind(int a, int b) {
        return 6;
    }

    public static void main(String[] arguments) {
        System.out.println(kind((byte) 1)); // expect 1
        System.out.println(kind(1L)); // expect 2
        System.out.println(kind('1')); // expect 3
        System.out.println(kind(new int[1])); // expect 4
        System.out.println(kind("1")); // expect 5
        System.out.println(kind(1, 1)); // expect 6
    }
}
