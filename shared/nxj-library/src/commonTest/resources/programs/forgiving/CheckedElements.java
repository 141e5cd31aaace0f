// In the forgiving mode, an object that does not fit into an array throws the exception that Java has for it.
public class CheckedElements {
    public static void main(String[] arguments) {
        Object[] texts = new String[2];
        try {
            texts[0] = 3;
            System.out.println("stored");
        } catch (ArrayStoreException wrong) {
            System.out.println("store"); // expect store
        }
        System.out.println(texts[0]); // expect null
        Object[] all = {"x", "y", 1, "z"};
        String[] copies = new String[4];
        try {
            System.arraycopy(all, 0, copies, 0, 4);
        } catch (ArrayStoreException wrong) {
            System.out.println(copies[1] + " " + copies[2] + " " + copies[3]); // expect y null null
        }
    }
}
