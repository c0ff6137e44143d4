#include "app/ui/figures/texture_objects.h"

namespace texplorer::ui {

const std::vector<ToldCall>& texbindCalls() {
    using namespace objects;
    constexpr const char* given = N_("glTexParameteri changes the bound object, which keeps the value.");
    constexpr const char* image = N_("glTexImage2D sets the image of the bound object.");
    static const std::vector<ToldCall> calls{
        {GenTexture{}, N_("Only a name: there is no object yet.")},
        {GenTexture{}, N_("texbind.c generates two names.")},
        {BindTexture{1}, N_("The first glBindTexture of a name creates the object with OpenGL's initial "
                            "values.")},
        {setWrapS(Wrap::Clamp), given},
        {setWrapT(Wrap::Clamp), given},
        {setParameter(MagFilter::Nearest), given},
        {setParameter(MinFilter::Nearest),
         N_("With the initial filter, which needs mipmaps, it would be incomplete.")},
        {GiveImage{0}, image},
        {BindTexture{2}, N_("A new object has the initial values, whatever the first one has.")},
        {setWrapS(Wrap::Clamp), given},
        {setWrapT(Wrap::Clamp), given},
        {setParameter(MagFilter::Nearest), given},
        {setParameter(MinFilter::Nearest), given},
        {GiveImage{1}, image},
        {SetEnvMode{EnvMode::Decal},
         N_("Set once, while object 2 is bound. But glTexEnvi changes the unit.")},
        {EnableTexture{true}, N_("glEnable changes the unit, too.")},
        {BindTexture{1},
         N_("Object 1 is bound again with its image and filters. The unit still has its environment.")},
        {BindTexture{2},
         N_("Object 2 is bound again. The environment was set only once and applies to both.")},
    };
    return calls;
}

} // namespace texplorer::ui
