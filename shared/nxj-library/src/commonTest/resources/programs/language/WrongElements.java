// A brick does not check which objects are stored in an array. What does not fit becomes null here.
// only here
public class WrongElements {
    interface Named { }

    static class Dog implements Named { }

    public static void main(String[] arguments) {
        Object[] texts = new String[2];
        texts[0] = "a";
        texts[1] = 3;
        System.out.println(texts[0] + " " + texts[1]); // expect a null
        Named[] named = new Dog[1];
        named[0] = new Named() { };
        System.out.println(named[0]); // expect null
        Object[] lists = new int[1][];
        lists[0] = new long[1];
        System.out.println(lists[0]); // expect null
        Object[] all = {"x", 1, "y", null, 2.5, "z"};
        String[] copies = {"1", "2", "3", "4", "5", "6", "7"};
        System.arraycopy(all, 0, copies, 1, 6);
        for (String copy : copies) System.out.println(copy); // expect 1
        // expect x
        // expect null
        // expect y
        // expect null
        // expect null
        // expect z
        try {
            System.arraycopy(all, 0, "text", 0, 1);
        } catch (ArrayStoreException wrong) {
            System.out.println("no array"); // expect no array
        }
        try {
            texts[2] = 3;
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println("index"); // expect index
        }
    }
}
