public class CastsToArrays {
    public static void main(String[] arguments) {
        Object thing = new int[3];
        boolean isArray = thing instanceof int[]; // refused: instanceof
        int[] numbers = (int[]) thing; // refused: checkcast
    }
}
