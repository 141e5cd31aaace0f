public class ArraysOfAllKinds {
    public static void main(String[] arguments) {
        byte[] bytes = {-1, 2};
        System.out.println(bytes[0] + bytes[1]); // expect 1
        short[] shorts = {-300, 400};
        System.out.println(shorts[0] + shorts[1]); // expect 100
        char[] letters = {'a', 'b'};
        System.out.println(letters[1] - letters[0]); // expect 1
        float[] decimals = {0.5f, 1.5f};
        System.out.println((int) (decimals[0] + decimals[1])); // expect 2
        double[] wide = {0.25, 3.75};
        System.out.println((int) (wide[0] + wide[1])); // expect 4
        Object[] things = {"text", new int[3], letters};
        System.out.println(things.length); // expect 3
    }
}
